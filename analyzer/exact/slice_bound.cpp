#include "analyzer/exact/slice_bound.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "analyzer/exact/cap.hpp"
#include "analyzer/machine/loss_rows.hpp"
#include "analyzer/slice/slice.hpp"
#include "analyzer/slice/talk.hpp"

namespace pal::analyzer {
namespace {

bool within(const Requirement& requirement, Nanoseconds value) {
  return !requirement.allowed().broken_by(value);
}

bool nearer(const Requirement& requirement, Nanoseconds value, const std::optional<Nanoseconds>& than) {
  return !than || requirement.allowed().worse(*than, value);
}

struct Attempt {
  std::size_t classes;
  ZoneGraph::Merging merging;
};

/// First as it is, then with fewer and larger classes.
constexpr Attempt attempts[] = {{100'000, ZoneGraph::Merging::within}, {400'000, ZoneGraph::Merging::hull}};

/// Classes in which the beginning of a skill is explored.
constexpr std::size_t most_of_beginning = 60'000;

/// A wait for a party that is left out, or a send to one.
bool is_loose(const Problem& slice, const Step& step) {
  const bool talks = step.kind == Step::Kind::wait || step.kind == Step::Kind::send;
  return talks && std::any_of(step.channels.begin(), step.channels.end(),
                              [&](ChannelId c) { return slice.channels[c].loose; });
}

/// Steps that lead to `step`.
Table<StepId, bool> leading_to(const Problem& problem, StepId step) {
  Table<StepId, bool> found(problem.steps.size());
  for (const StepId s : found.ids()) {
    const std::vector<StepId>& next = problem.steps[s].next;
    found[s] = std::find(next.begin(), next.end(), step) != next.end();
  }
  return found;
}

/// The longest time in the whole problem from reaching `step` until its thread is past it; nothing, if it was
/// not found. The step comes once at most.
std::optional<Nanoseconds> longest(const Problem& problem, StepId step, const Limits& limits,
                                   Statistics& statistics) {
  const std::size_t all = problem.threads.size();
  Problem first =
      slice_of(problem,
               {Table<ThreadId, bool>(all, true), Table<DeviceId, bool>(problem.devices.size(), true),
                Table<DeviceId, bool>(problem.devices.size(), false)},
               {true, true});
  Step past;
  past.kind = Step::Kind::complete;
  for (Step& each : first.steps) {
    if (each.kind == Step::Kind::complete) each.code = -1;
  }
  first.error_code = -1;
  const StepId behind = first.steps.push_back(past);
  for (StepId& next : first.steps[step].next) next = behind;
  Requirement until;
  until.measure = Requirement::Measure::duration;
  const Table<StepId, bool> before = leading_to(problem, step);
  if (std::find(before.begin(), before.end(), true) != before.end()) until.phase.after = before;
  const SliceBound found = bound_in(first, until, cap_of(problem, 0), limits);
  statistics += found.statistics;
  return found.bound;
}

/// Says of waits at the beginning, for a party that is left out, and of sends to it, how long they last.
void limit_beginning(const Problem& problem, Problem& slice, const Limits& limits, Statistics& statistics) {
  const Table<ThreadId, ThreadTalk> talk = talk_of(problem);
  for (const ThreadId t : talk.ids()) {
    const Thread& thread = slice.threads[t];
    if (thread.parent.valid() || thread.left_out) continue;
    for (const StepId s : talk[t].beginning) {
      Step& step = slice.steps[s];
      if (!is_loose(slice, step)) continue;
      const auto found = longest(problem, s, limits, statistics);
      if (!found) break;
      step.arrival.worst = std::max(*found, step.arrival.best);
    }
  }
}

}  // namespace

SliceBound bound_in(const Problem& slice, const Requirement& requirement, Nanoseconds cap,
                    const Limits& limits, ZoneGraph::Merging merging) {
  const Watch watch = watch_of(slice, requirement);
  const Machine machine(slice, watch);
  ZoneGraph graph(machine, cap, false, merging);
  SliceBound found;
  found.complete = graph.explore(limits);
  found.beyond = graph.over_cap();
  found.statistics.states = graph.places().size();
  found.statistics.classes = graph.classes().size();
  // The least interval is bounded whatever the others are.
  const bool grown = !watch.least && (graph.over_cap() || graph.never_answered() || graph.stuck() >= 0);
  if (found.complete && !grown && !graph.failure() && graph.peak().value >= 0)
    found.bound = bound_of_row(requirement, graph.peak().value);
  return found;
}

namespace {

/// Explores the slices of a requirement, each first with values up to the limit alone: all that is greater is
/// the same then. That decides, and takes fewer classes. How far beyond the limit it can go is looked at
/// last.
class SliceExplorer {
 public:
  SliceExplorer(const Problem& problem, const Requirement& requirement, const Options& options,
                std::size_t classes)
      : problem_(problem),
        requirement_(requirement),
        options_(options),
        classes_(classes),
        workers_(options.threads) {}

  SliceBound run() {
    const Nanoseconds all = cap_of(problem_, requirement_.limit);
    const bool time = requirement_.measure != Requirement::Measure::loss && !requirement_.at_least;
    if (time && requirement_.limit < all && (!explore_all(requirement_.limit, true) || decided()))
      return best_;
    explore_all(all, false);
    return best_;
  }

 private:
  /// With more and more that is as it is. False: one of the slices is too large.
  bool explore_all(Nanoseconds cap, bool until_beyond) {
    constexpr Relaxation relaxations[] = {{true, true}, {true, false}};
    for (std::size_t r = 0; r < std::size(relaxations); ++r) {
      if (r == slices_.size()) slices_.push_back(made(relaxations[r]));
      if (!explore(slices_[r], cap, until_beyond)) return false;
      if (decided()) break;
    }
    return true;
  }

  Problem made(Relaxation relaxation) {
    Problem slice = slice_of(problem_, cone_of(problem_, requirement_), relaxation);
    limit_beginning(problem_, slice, limits(most_of_beginning), best_.statistics);
    return slice;
  }

  /// `until_beyond`: a value beyond the cap ends it.
  bool explore(const Problem& slice, Nanoseconds cap, bool until_beyond) {
    for (const Attempt& attempt : attempts) {
      Limits until = limits(attempt.classes);
      if (until_beyond) until.enough = [](const ZoneGraph& graph) { return graph.over_cap(); };
      const SliceBound found = bound_in(slice, requirement_, cap, until, attempt.merging);
      best_.statistics += found.statistics;
      if (found.complete) best_.complete = true;
      if (found.bound && nearer(requirement_, *found.bound, best_.bound)) best_.bound = found.bound;
      if (found.complete || (until_beyond && found.beyond)) return true;
    }
    return false;
  }

  Limits limits(std::size_t classes) { return {std::min(classes_, classes), options_.stop, {}, &workers_}; }
  bool decided() const { return best_.bound && within(requirement_, *best_.bound); }

  const Problem& problem_;
  const Requirement& requirement_;
  const Options& options_;
  std::size_t classes_;
  Workers workers_;
  std::vector<Problem> slices_;  // by relaxation
  SliceBound best_;
};

}  // namespace

SliceBound slice_bound(const Problem& problem, const Requirement& requirement, const Options& options,
                       std::size_t classes) {
  return SliceExplorer(problem, requirement, options, classes).run();
}

}  // namespace pal::analyzer
