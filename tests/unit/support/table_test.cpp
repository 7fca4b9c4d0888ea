#include "pal/support/table.hpp"

#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <type_traits>

#include "pal/support/id.hpp"

using pal::Id;
using pal::Table;

namespace {

using TreeId = Id<struct TreeTag>;
using BirdId = Id<struct BirdTag>;

template <class Container, class Index>
concept IndexedBy = requires(Container container, Index index) {
  container[index];
};

}  // namespace

TEST_CASE("a table is indexed by its own ids only") {
  STATIC_REQUIRE(IndexedBy<Table<TreeId, int>, TreeId>);
  STATIC_REQUIRE_FALSE(IndexedBy<Table<TreeId, int>, BirdId>);
  STATIC_REQUIRE_FALSE(IndexedBy<Table<TreeId, int>, int>);
  STATIC_REQUIRE_FALSE(std::is_convertible_v<TreeId, int>);
  STATIC_REQUIRE_FALSE(std::is_convertible_v<std::size_t, TreeId>);
}

TEST_CASE("a table says which id a new value has") {
  Table<TreeId, std::string> trees;
  CHECK_FALSE(trees.contains(TreeId{}));
  const TreeId oak = trees.push_back("oak");
  const TreeId elm = trees.push_back("elm");
  CHECK(oak != elm);
  CHECK(trees[oak] == "oak");
  CHECK(trees[elm] == "elm");
  CHECK(trees.size() == 2);
  CHECK(trees.contains(elm));
  CHECK_FALSE(trees.contains(TreeId{2}));
}

TEST_CASE("the ids of a table come in order, each once") {
  Table<TreeId, bool> tall(3);
  tall[TreeId{1}] = true;
  std::string seen;
  for (const TreeId tree : tall.ids()) seen += std::to_string(tree.index()) + (tall[tree] ? " tall, " : ", ");
  CHECK(seen == "0, 1 tall, 2, ");
  const auto ids = tall.ids();
  CHECK(std::set<TreeId>(ids.begin(), ids.end()).size() == tall.size());
}

TEST_CASE("an id that names nothing comes before all others") {
  CHECK_FALSE(TreeId{}.valid());
  CHECK(TreeId::of(-1) == TreeId{});
  CHECK(TreeId::of(4) == TreeId{4});
  CHECK(TreeId{} < TreeId{0});
}
