// What all stages of the time analysis read: the problem, its forest of causes, and how its threads behave.
#pragma once

#include "analyzer/compositional/causes/thread_behaviour.hpp"

namespace pal::analyzer::compositional {

struct AnalysisContext {
  const Problem& problem;
  const Forest& forest;
  const ThreadBehaviours& behaviours;

  const Node& node(NodeId n) const { return forest.nodes[n]; }
  const Segment& segment(NodeId n) const { return forest.segment_of(node(n)); }
  const Source& source(NodeId n) const { return forest.sources[node(n).source]; }
  const Step& step_at(StepId step) const { return problem.steps[step]; }
  const Thread& thread_at(ThreadId thread) const { return problem.threads[thread]; }
  const Thread& thread_of(NodeId n) const { return thread_at(forest.thread_of(n)); }
  const ThreadBehaviour& behaviour_of(ThreadId thread) const { return behaviours.threads[thread]; }
  NodeId job_start_of(NodeId n) const { return behaviours.job_start[n]; }
  bool in_job(NodeId n) const { return compositional::in_job(forest, behaviours, n); }
  /// The node itself or its nearest cause that belongs to `thread`, if there is one.
  NodeId nearest(NodeId n, ThreadId thread) const {
    return forest.thread_of(n) == thread ? n : forest.cause_in(n, thread);
  }
  /// Nodes that may end the skill or a thread before `thread` is idle for the first time. They belong to
  /// `thread`, to its parents, or to the threads that these wait for.
  std::vector<NodeId> endings_before_idle(ThreadId thread) const;
  /// The same before the first job of a loop. An event has none.
  std::vector<NodeId> endings_before_first(SourceId loop) const;
  ChannelId sent_channel(NodeId n) const { return step_at(node(n).sends.front()).channels.front(); }

  /// Time from a request to its answer when the device is free.
  Range device_time(DeviceId device) const;
  /// Time from the send until the node's message, or the device's answer to it, can be received.
  Range way(NodeId n) const;
  /// How long a request may queue at a device that answers on request; `never`: unbounded.
  Nanoseconds answer_queue(DeviceId device, ChannelId request) const;
};

/// Whether a wait for the answer to a request may time out.
bool may_give_up(const Problem& problem, ChannelId request);

/// Least time from the release of a node's cause to its own; the node is no root.
Nanoseconds earliest_after_cause(const AnalysisContext& context, NodeId node);

/// The earliest release of each node after the nominal instant of its source. After `stop` has returned true,
/// a lower bound of it.
Table<NodeId, Nanoseconds> earliest_releases(const AnalysisContext& context,
                                             const std::function<bool()>& stop);

}  // namespace pal::analyzer::compositional
