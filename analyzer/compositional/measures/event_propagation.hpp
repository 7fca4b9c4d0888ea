// What an event, or a message, brings about: where its response is.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analyzer/compositional/measures/measures.hpp"

namespace pal::analyzer::compositional {

/// Follows an event, or a message, from node to node and thread to thread, as far as every run must propagate
/// it. It ends when one of the statements `at` takes effect, or when the skill ends.
class EventPropagation {
 public:
  /// What times count from.
  enum class Since { event, nominal };

  EventPropagation(const View& view, const Table<StepId, bool>& at, Since since)
      : view_(view), problem_(view.problem), at_(at), since_(since) {}

  /// Latest first effect of a statement, if a message triggers this node.
  Sum node_value(NodeId n);
  /// The same for the message that `n` sends by `send` to its only receiver.
  Sum sent_value(NodeId n, StepId send);
  /// Whether the thread of the node makes progress in every run, as long as the skill lasts.
  bool certain(NodeId n);
  /// Why a value is unbounded; empty if no reason was found.
  const Why& why() const { return why_; }

 private:
  /// No path leads from here to an answer, nor to anything else.
  static Sum no_way() { return Sum::number(-1); }

  const Node& node(NodeId n) const { return view_.forest.nodes[n]; }
  const Segment& segment(NodeId n) const { return view_.forest.segment_of(node(n)); }
  const Step& step_at(StepId step) const { return problem_.steps[step]; }

  Sum reached(NodeId n, StepId step) const {
    return since_ == Since::event ? since_event(view_, n, step) : latest(view_, n, step);
  }
  Sum finished(NodeId n) const {
    return since_ == Since::event ? finish_since_event(view_, n) : finish(view_, n);
  }
  const Why& unbounded_reason_of(NodeId n) const;
  Sum beginning_value(NodeId n);
  Sum step_value(NodeId n, StepId at);
  /// The same from the results of the steps that follow.
  Sum value_of_step(NodeId n, StepId at);
  /// Each block propagates the event, and so does its parent after they have ended.
  Sum fork_value(NodeId n, StepId fork);
  Sum wait_value(NodeId n, StepId wait);

  const View& view_;
  const Problem& problem_;
  const Table<StepId, bool>& at_;
  Since since_;
  std::map<NodeId, Sum> nodes_;
  std::map<std::pair<NodeId, StepId>, Sum> steps_;
  Why why_;
};

}  // namespace pal::analyzer::compositional
