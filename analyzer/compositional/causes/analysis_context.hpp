// What the times of a problem are reckoned from.
#pragma once

#include "analyzer/compositional/causes/thread_behaviour.hpp"

namespace pal::analyzer::compositional {

struct AnalysisContext {
  const Problem& problem;
  const Forest& forest;
  const ThreadBehaviours& behaviours;

  const Node& node(int n) const { return forest.nodes[static_cast<std::size_t>(n)]; }
  const Segment& segment(int n) const { return forest.segment_of(node(n)); }
  const Source& source(int n) const { return forest.sources[static_cast<std::size_t>(node(n).source)]; }
  const Step& step_at(int step) const { return problem.steps[static_cast<std::size_t>(step)]; }
  const Thread& thread_at(int thread) const { return problem.threads[static_cast<std::size_t>(thread)]; }
  const Thread& thread_of(int n) const { return thread_at(forest.thread_of(n)); }
  const ThreadBehaviour& behaviour_of(int thread) const {
    return behaviours.threads[static_cast<std::size_t>(thread)];
  }
  int job_start_of(int n) const { return behaviours.job_start[static_cast<std::size_t>(n)]; }
  bool in_job(int n) const { return compositional::in_job(forest, behaviours, n); }
  /// The node, if it is one of a thread, or the nearest of its causes that is; -1: it does not come of the
  /// thread.
  int nearest(int n, int thread) const {
    return forest.thread_of(n) == thread ? n : forest.cause_in(n, thread);
  }
  /// Nodes that may end the skill, or a thread, on behalf of what `thread`, or the one whose block it is,
  /// does before it is at home: their own, and those of whom they wait for.
  std::vector<int> endings_before_idle(int thread) const;
  /// The same, on behalf of what leads to the first round of a loop. Of an event there are none.
  std::vector<int> endings_before_first(int loop) const;
  int sent_channel(int n) const { return step_at(node(n).sends.front()).channels.front(); }

  /// Distance from a request's effect to its answer, once the device is free.
  Range device_time(int device) const;
  /// Distance from the send to where the node's message, or the device's answer to it, can be taken.
  Range way(int n) const;
  /// How long a request may wait for a device that answers on request; `never`: nothing bounds it.
  Nanoseconds answer_queue(int device, int request) const;
};

/// Whether somebody may give up waiting for the answer to a request.
bool may_give_up(const Problem& problem, int request);

/// The earliest that each node can be released, from the nominal instant of its source. Once `stop` says so,
/// no later than that.
std::vector<Nanoseconds> earliest_releases(const AnalysisContext& context, const std::function<bool()>& stop);

}  // namespace pal::analyzer::compositional
