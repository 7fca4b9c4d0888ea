// Where a long drawing goes on in another column.
#include <catch2/catch.hpp>

#include "pal/pan/dot_flow.hpp"
#include "pal/pan/dot_folds.hpp"

namespace pal::pan {
namespace {

/// A start, a number of statements, an end.
Graph straight(std::size_t statements) {
  Graph body;
  for (std::size_t i = 0; i < statements + 2; ++i) {
    Node node;
    node.content = i == 0 ? Content(Start{}) : i == statements + 1 ? Content(End{}) : Content(Nothing{});
    if (i <= statements) node.out = {NodeId(i + 1)};
    body.nodes.push_back(std::move(node));
  }
  return body;
}

/// How many nodes stand in each column.
std::vector<std::size_t> heights(const Graph& body, std::size_t most) {
  const DotFlow flow(body);
  const DotFolds folds(body, flow, most);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    result.resize(std::max(result.size(), folds.column(i) + 1));
    ++result[folds.column(i)];
  }
  return result;
}

TEST_CASE("what fits into one column is not folded") {
  CHECK(heights(straight(46), 48) == std::vector<std::size_t>{48});
}

TEST_CASE("a hundred statements stand in columns of about the same height") {
  CHECK(heights(straight(100), 48) == std::vector<std::size_t>{34, 34, 34});
}

TEST_CASE("no column begins within a CASE, however long its arms are") {
  // Node 2 is a CASE of two arms of thirty statements each, which meet at node 63.
  Graph body = straight(100);
  body.nodes[2].content = Choose{{Guard{}, Guard{}}};
  body.nodes[2].out = {NodeId(3), NodeId(33)};
  body.nodes[2].mate = NodeId(63);
  body.nodes[32].out = {NodeId(63)};
  body.nodes[63].content = Merge{};
  body.nodes[63].mate = NodeId(2);
  const DotFlow flow(body);
  const DotFolds folds(body, flow, 20);
  bool any = false;
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    CAPTURE(i);
    if (i >= 3 && i <= 63) CHECK_FALSE(folds.begins(i));
    any = any || folds.begins(i);
  }
  CHECK(any);
}

}  // namespace
}  // namespace pal::pan
