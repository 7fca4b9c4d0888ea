// Programs with tangled causes. Each gets random figures and requirements of every measure.
#include <catch2/catch.hpp>
#include <filesystem>
#include <random>
#include <string>

#include "analyzer/compositional/causes/forest.hpp"
#include "tests/differential/compare.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/kinds.hpp"
#include "tests/support/project_file.hpp"
#include "tests/support/refigured.hpp"
#include "tests/support/setting.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;

TEST_CASE("no run of a skill with tangled causes exceeds a bound of either analysis") {
  const std::filesystem::path root = PAL_SOURCE_DIR;
  const std::uint64_t first = setting("PAL_SEED", 1);
  const test::Effort effort{setting("PAL_CLASSES", 500), setting("PAL_WALKS", 6), 600, true};
  test::Compared all;
  for (const auto& entry : std::filesystem::directory_iterator(root / "tests/differential/causes")) {
    const std::string text = test::project_file(std::filesystem::relative(entry.path(), root).string());
    for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 1); ++seed) {
      std::mt19937_64 engine(seed);
      const std::string other = test::refigured(text, engine);
      all += test::compare(
          test::asked_everything(test::has_meaning(other) ? other : text, engine, setting("PAL_ASKED", 40)),
          seed, effort);
      INFO(entry.path().filename() << ", seed " << seed << "\n" << all.contradiction);
      REQUIRE(all.contradiction.empty());
    }
  }
  CHECK(all.bounded > 0);
  CHECK(all.measured > 0);
}

TEST_CASE("a job that begins with blocks is not taken as one without time") {
  const auto skill =
      test::meaningful_skill(test::project_file("tests/differential/causes/begins_with_blocks.pal"));
  CHECK(compositional::forest_of(*skill->problem, {}).refusal.text ==
        "nothing says how long a job of module SM1 takes at least");
}
