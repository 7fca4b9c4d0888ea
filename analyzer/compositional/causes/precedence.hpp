// Which segments can be under way at a time, and which never are.
#pragma once

#include <functional>

#include "analyzer/compositional/causes/analysis_context.hpp"

namespace pal::analyzer::compositional {

/// By node, ascending.
struct Order {
  /// Nodes whose work is never there before this one is done, in no run: by the order of a module's program;
  /// and what goes round only once something that comes once in a skill's life has brought it about.
  std::vector<std::vector<int>> later;
  /// Nodes each of whose jobs is either done before a job of this one is released, or comes after it is done:
  /// what has brought it about, the blocks that it comes after, and what goes round with it if there is one
  /// message only that goes round.
  std::vector<std::vector<int>> never_overlapping;
};

/// Once `stop` says so, it is what is known by then.
Order order_of(const AnalysisContext& context, const std::function<bool()>& stop);

}  // namespace pal::analyzer::compositional
