// The greatest ratio of a cycle in a graph whose edges have two weights.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
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

/// Whether the times of every cycle, and products of two such sums, can be added up. They must stay below
/// 2^61 nanoseconds (73 years) even if each edge takes as long as the longest. Otherwise
/// greatest_cycle_ratio() must not be called.
bool can_add_up(int nodes, const std::vector<WeightedEdge>& edges);

/// Greatest sum(work) / sum(time) over all cycles that take time; nothing if there is no such cycle. The
/// result is exact (E. L. Lawler, Combinatorial optimization, 1976). A cycle is better than a ratio iff it is
/// positive for weights work - ratio · time. Every better cycle found gives the next ratio.
std::optional<CycleRatio> greatest_cycle_ratio(int nodes, const std::vector<WeightedEdge>& edges);

__extension__ using Gain = __int128;

/// Finds cycles of a graph whose edges gain or lose, by longest paths from everywhere at once.
class PositiveCycle {
 public:
  /// Ends of the edges: nodes from 0 to `nodes` - 1.
  PositiveCycle(int nodes, std::vector<std::pair<int, int>> edges);

  /// A cycle whose gains add up to more than nothing, as indices of edges in order; `gains` has one for each
  /// edge. Empty: there is none.
  std::vector<int> find(const std::vector<Gain>& gains);

 private:
  std::vector<int> in_parents() const;

  std::vector<std::pair<int, int>> edges_;
  std::vector<std::size_t> first_;
  std::vector<int> order_;
  std::vector<Gain> distance_;
  std::vector<int> parent_;
};

}  // namespace pal::analyzer
