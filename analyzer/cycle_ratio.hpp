// The greatest ratio of a cycle in a graph whose edges have two weights.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace pal::analyzer {

/// work <= time, both at least 0, in one unit.
struct WeightedEdge {
  int from = 0;
  int to = 0;
  std::int64_t work = 0;
  std::int64_t time = 0;
};

struct CycleRatio {
  std::int64_t work = 0;
  std::int64_t time = 1;
  std::vector<int> edges;  // the cycle, as indices, in order
};

/// Greatest sum(work) / sum(time) over all cycles that take time; nothing if there is no such cycle. Exact:
/// E. L. Lawler, Combinatorial optimization, 1976: a cycle is better than a ratio iff it is positive for
/// weights work - ratio · time; every better cycle found gives the next ratio.
std::optional<CycleRatio> greatest_cycle_ratio(int nodes, const std::vector<WeightedEdge>& edges);

}  // namespace pal::analyzer
