// Cycles of a graph round which something is gained.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace pal::analyzer {

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
