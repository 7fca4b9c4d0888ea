// Bounds on loads by shares of the time, where they can be reckoned by hand.
#include "analyzer/load/share_bound.hpp"

#include <catch2/catch.hpp>

using namespace pal::analyzer;

namespace {

__extension__ using Wide = __int128;

/// Two timers that go on at once, each started again by its own end: in `first` and `second` nanoseconds
/// there is so much work. Only sums over cycles count, so each is a cycle of its own at one node.
WorkGraph two_timers(Passing first, std::int64_t first_work, Passing second, std::int64_t second_work) {
  WorkGraph graph;
  graph.nodes = 1;
  graph.shares = 2;
  graph.edges = {{0, 0, first_work, {first}}, {0, 0, second_work, {second}}};
  graph.together = {{0, 1}};
  return graph;
}

}  // namespace

TEST_CASE("shares of simultaneous timers add up") {
  const auto bound = share_bound(two_timers({0, 10}, 3, {1, 15}, 5), {}, {});
  REQUIRE(bound);
  CHECK(bound->work * 30 == bound->time * 19);  // 3/10 + 5/15
}

TEST_CASE("shares of timers that never run at once do not add up") {
  WorkGraph graph = two_timers({0, 10}, 3, {1, 15}, 5);
  graph.together = {{0}, {1}};
  const auto bound = share_bound(graph, {}, {});
  REQUIRE(bound);
  CHECK(bound->work * 3 == bound->time);
}

TEST_CASE("the search for a bound by shares gives up above the limit") {
  const WorkGraph graph = two_timers({0, 10}, 3, {1, 15}, 5);
  CHECK_FALSE(share_bound(graph, Fraction{6, 10}, {}));
  CHECK(share_bound(graph, Fraction{7, 10}, {}));
}

// The times are prime: the bound's denominator is 10^18 and more, which is rounded, and never down.
TEST_CASE("a bound by shares with long numbers is rounded up by a part in 10^12 at most") {
  const std::int64_t first = 1'000'000'007;
  const std::int64_t second = 1'000'000'009;
  const std::int64_t work = 123'456'789;
  const auto bound = share_bound(two_timers({0, first}, work, {1, second}, work), {}, {});
  REQUIRE(bound);
  const Wide exact = static_cast<Wide>(work) * (first + second);
  const Wide whole = static_cast<Wide>(first) * second;
  const Wide above = static_cast<Wide>(bound->work) * whole - exact * bound->time;
  CHECK(above >= 0);
  CHECK(above * 1'000'000'000'000 <= static_cast<Wide>(bound->time) * whole);
}
