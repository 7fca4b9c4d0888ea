// Releases that count from the release of a common cause, among segments that come once.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/causes/precedence.hpp"

namespace pal::analyzer::compositional {

/// Times counted so do not contain what makes both the cause and the node late. They may be far shorter than
/// times that count from the start of the skill.
class SinceCause {
 public:
  SinceCause(const AnalysisContext& context, std::shared_ptr<const Order> order)
      : context_(context), order_(std::move(order)) {}

  /// The last node from which both come: it, or one of its causes, if there is one.
  NodeId common(NodeId one, NodeId other) const;
  /// Least time from the release of `cause` to that of `node`, which comes of it.
  Nanoseconds least(NodeId cause, NodeId node) const;
  /// Whether all that the release of `node` waits for comes of `cause`, or is over when `cause` is released.
  /// Then no more time passes between the two releases than between their latest instants. False: `cause` may
  /// come again, or too many nodes would have to be looked at.
  bool counts_from(NodeId cause, NodeId node);

 private:
  Table<NodeId, bool> counting_from(NodeId cause) const;
  bool counts(NodeId node, NodeId cause, const Table<NodeId, bool>& known) const;

  AnalysisContext context_;
  std::shared_ptr<const Order> order_;
  std::map<NodeId, Table<NodeId, bool>> counting_;  // by cause: nodes
};

}  // namespace pal::analyzer::compositional
