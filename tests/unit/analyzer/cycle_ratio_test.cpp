#include "analyzer/load/cycle_ratio.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <random>

using namespace pal::analyzer;

namespace {

/// All simple cycles, one after the other.
std::optional<CycleRatio> by_trying(int nodes, const std::vector<WeightedEdge>& edges) {
  std::optional<CycleRatio> best;
  std::vector<bool> used(static_cast<std::size_t>(nodes));
  const std::function<void(int, int, std::int64_t, std::int64_t)> go =
      [&](int start, int at, std::int64_t work, std::int64_t time) {
        for (const WeightedEdge& edge : edges) {
          if (edge.from != at) continue;
          if (edge.to == start && time + edge.time > 0) {
            const CycleRatio found{work + edge.work, time + edge.time, {}};
            if (!best || found.work * best->time > best->work * found.time) best = found;
          }
          if (edge.to <= start || used[static_cast<std::size_t>(edge.to)]) continue;
          used[static_cast<std::size_t>(edge.to)] = true;
          go(start, edge.to, work + edge.work, time + edge.time);
          used[static_cast<std::size_t>(edge.to)] = false;
        }
      };
  for (int n = 0; n < nodes; ++n) go(n, n, 0, 0);
  return best;
}

}  // namespace

TEST_CASE("the greatest ratio is that of the better of two cycles") {
  const std::vector<WeightedEdge> edges{{0, 1, 1, 2}, {1, 0, 1, 4}, {1, 2, 0, 1}, {2, 1, 2, 3}};
  const auto found = greatest_cycle_ratio(3, edges);
  REQUIRE(found);
  CHECK(found->work * 2 == found->time);
}

TEST_CASE("a cycle that takes no time has no ratio") {
  CHECK_FALSE(greatest_cycle_ratio(2, {{0, 1, 0, 0}, {1, 0, 0, 0}}));
  CHECK_FALSE(greatest_cycle_ratio(2, {{0, 1, 1, 1}}));
}

TEST_CASE("cycles whose times do not fit into 64 bits are recognised") {
  const std::int64_t longest = 1'000'000'000'000'000;
  CHECK(can_add_up(2'000, {{0, 1, 1, longest}, {1, 0, 1, 1}}));
  CHECK_FALSE(can_add_up(3'000, {{0, 1, 1, 1}, {1, 0, 1, longest}}));
  const auto found = greatest_cycle_ratio(2, {{0, 1, longest, longest}, {1, 0, 0, longest}});
  REQUIRE(found);
  CHECK(found->work == longest);
  CHECK(found->time == 2 * longest);
}

TEST_CASE("the greatest ratio equals that of trying every cycle") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    INFO("seed " << seed);
    std::mt19937_64 engine(seed);
    const int nodes = 2 + static_cast<int>(engine() % 5);
    std::vector<WeightedEdge> edges;
    for (int e = 0; e < 3 * nodes; ++e) {
      const auto time = static_cast<std::int64_t>(engine() % 6);
      const std::int64_t work =
          time == 0 ? 0 : static_cast<std::int64_t>(engine() % static_cast<std::uint64_t>(time + 1));
      edges.push_back({static_cast<int>(engine() % static_cast<std::uint64_t>(nodes)),
                       static_cast<int>(engine() % static_cast<std::uint64_t>(nodes)), work, time});
    }
    const auto found = greatest_cycle_ratio(nodes, edges);
    const auto expected = by_trying(nodes, edges);
    REQUIRE(found.has_value() == expected.has_value());
    if (found) CHECK(found->work * expected->time == expected->work * found->time);
  }
}
