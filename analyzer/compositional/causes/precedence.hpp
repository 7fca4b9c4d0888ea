// Precedence: which segments never overlap.
#pragma once

#include <functional>

#include "analyzer/compositional/causes/analysis_context.hpp"

namespace pal::analyzer::compositional {

/// By node, ascending.
struct Order {
  /// Nodes that are released only after this one is done, in every run. They come later in a module's
  /// program, or in a loop whose trigger happens once in a skill's life.
  Table<NodeId, std::vector<NodeId>> later;
  /// Nodes whose runs are each done before a run of this one is released, or released after it is done. These
  /// are its causes, and nodes of the same cycle if only one message circulates in it.
  Table<NodeId, std::vector<NodeId>> never_overlapping;
};

/// After `stop` has returned true, what was found so far.
Order order_of(const AnalysisContext& context, const std::function<bool()>& stop);

}  // namespace pal::analyzer::compositional
