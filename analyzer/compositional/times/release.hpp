// The latest release of a node, and what it waits for until then.
#pragma once

#include "analyzer/compositional/causes/analysis_context.hpp"
#include "analyzer/compositional/times/interference.hpp"
#include "analyzer/compositional/times/times.hpp"

namespace pal::analyzer::compositional {

/// Reads the times of the current iteration.
class Releases : private AnalysisContext {
 public:
  Releases(const AnalysisContext& context, const Table<NodeId, NodeTimes>& nodes,
           const Interference& interference)
      : AnalysisContext(context), nodes_(nodes), nominal_(nodes), interference_(interference) {}
  /// `since_event`: times that count from the events themselves, where those of `nominal` count from their
  /// nominal instants.
  Releases(const AnalysisContext& context, const Table<NodeId, NodeTimes>& since_event,
           const Table<NodeId, NodeTimes>& nominal, const Interference& interference)
      : AnalysisContext(context), nodes_(since_event), nominal_(nominal), interference_(interference) {}

  /// `unbounded_reason` and `blocked` as in Times.
  Due latest(NodeId node, const Table<ThreadId, Why>& unbounded_reason,
             const Table<ThreadId, bool>& blocked) const;

 private:
  Due of_event(NodeId node) const;
  Due of_message(NodeId node) const;
  Nanoseconds blocks_over(const Node& joined, const Table<ThreadId, Why>& unbounded_reason,
                          const Table<ThreadId, bool>& blocked) const;
  Nanoseconds held_back(ThreadId thread) const;
  Nanoseconds arrival(NodeId node, StepId step) const;

  const Table<NodeId, NodeTimes>& nodes_;
  const Table<NodeId, NodeTimes>& nominal_;  // what concerns other jobs counts from nominal instants
  const Interference& interference_;
};

}  // namespace pal::analyzer::compositional
