// Bounds of what requirements measure, from the times of segments.
#pragma once

#include <functional>
#include <utility>

#include "analyzer/compositional/causes/exclusive.hpp"
#include "analyzer/compositional/measures/sum.hpp"
#include "analyzer/compositional/times/interference.hpp"

namespace pal::analyzer::compositional {

/// No run exceeds it. If it is unbounded, `why` gives the reason.
struct Bound {
  Sum sum = Sum::unbounded();
  Why why = {};

  bool known() const { return sum.bounded(); }
};

struct View {
  const Problem& problem;
  const Forest& forest;
  const ThreadBehaviours& behaviours;
  const Times& times;
  /// By thread: it returns to its idle wait after every job, in every run, as long as the skill lasts and it
  /// is not cancelled.
  const Table<ThreadId, bool>& reliable;
  /// By thread: whatever it waits for within a job arrives.
  const Table<ThreadId, bool>& lively;
  /// By thread: it begins in every run.
  const Table<ThreadId, bool>& begun;
  /// Covers only the time before the first block leaves its loop.
  bool steady = false;

  const BusyWindows& windows() const { return times.interference->windows(); }
  bool withholds(Withheld withheld) const { return forest.withholds(withheld); }
  bool lasts(ThreadId thread) const {
    const ThreadId t = thread;
    return !behaviours.threads[t].may_be_cancelled && reliable[t];
  }
};

inline Bound no_bound(Why why) {
  return {Sum::unbounded(), std::move(why)};
}

/// The effect of a step in a node at the latest, and at the earliest; the node's end.
Sum latest(const View& view, NodeId node, StepId step);
Sum earliest(const View& view, NodeId node, StepId step);
Sum finish(const View& view, NodeId node);
/// The release of a node at the latest.
Sum release(const View& view, NodeId node);
/// The effect of a step in a node, and the node's end, at the latest after the event that brings it about.
Sum since_event(const View& view, NodeId node, StepId step);
Sum finish_since_event(const View& view, NodeId node);
/// The effect of a step at the latest after the release of a cause from which it counts (SinceCause).
Sum since_cause(const View& view, NodeId cause, StepEffect effect);
/// From one occurrence of a source to the next, and from time 0 to the first, at the latest.
Sum gap(const View& view, SourceId source);
Sum first(const View& view, SourceId source);

Bound response_bound(const View& view, const Requirement& requirement);
/// By step: whether it sends what a response is required to.
Table<StepId, bool> sends_of_events(const Problem& problem, const Requirement& requirement);
/// Whether each occurrence of a source of one root leads to a statement, as long as the skill lasts.
bool always_comes(const View& view, SourceId source, const Table<StepId, bool>& at);
/// Number of events or answers lost in any row of the length that the requirement names.
Bound loss_bound(const View& view, const Requirement& requirement);
Bound event_loss_bound(const View& view, const Requirement& requirement);
Bound age_bound(const View& view, const Requirement& requirement);
/// Derived from the freshness of data; for a condition age_bound may be tighter.
Bound known_age_bound(const View& view, const Requirement& requirement);
Bound reaction_bound(const View& view, const Requirement& requirement);
/// Between two effects of statements, at the least: 0 if nothing keeps them apart, unbounded if there is one
/// at most.
Sum least_distance(const View& view, const Table<StepId, bool>& at);
/// Of a least interval: no run falls below the value.
Bound interval_bound(const View& view, const Requirement& requirement);
Bound duration_bound(const View& view, const Requirement& requirement);
/// Nanoseconds of work in a second; of the processor that has most.
Bound load_bound(const View& view, const Requirement& requirement);
Bound busy_bound(const View& view, const Requirement& requirement);

/// How long threads go on.
struct Endurance {
  struct Threads {
    Table<ThreadId, bool> reliable;  // View::reliable
    Table<ThreadId, bool> lively;    // View::lively
    Table<ThreadId, bool> begun;     // View::begun
  };
  Threads always;
  Threads steady;                 // until the first block leaves its loop
  std::vector<ThreadId> leavers;  // the blocks that do
  Sum over;                       // from then until the skill has ended; unbounded: it may go on
};

/// A bound for skills that end when a block leaves its loop. It is `bound_of` for the time before, plus what
/// the time until the end of the skill may add.
Bound until_left(const View& always, const Endurance& endurance, const Requirement& requirement,
                 const std::function<Bound(const View&, const Requirement&)>& bound_of);

Endurance endurance_of(const Problem& problem, const Forest& forest, const ThreadBehaviours& behaviours,
                       const Times& times);

}  // namespace pal::analyzer::compositional
