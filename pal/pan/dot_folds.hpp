// Where a drawing that would be too long continues in another column (or line, from left to right).
#pragma once

#include <cstddef>
#include <vector>

#include "pal/pan/dot_flow.hpp"
#include "pal/pan/graph.hpp"

namespace pal::pan {

class DotFolds {
 public:
  /// `most`: how many nodes in a row fit into one column. `body` and `flow` are of one module.
  DotFolds(const Graph& body, const DotFlow& flow, std::size_t most);

  /// Does a column begin with this node? Then only one way leads there. It is the only way out of the columns
  /// before, except for those back to the beginning of a loop.
  bool begins(std::size_t node) const { return begins_[node]; }
  /// The column of a node, from 0.
  std::size_t column(std::size_t node) const { return columns_[node]; }

 private:
  std::vector<bool> begins_;
  std::vector<std::size_t> columns_;
};

}  // namespace pal::pan
