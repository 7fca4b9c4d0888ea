#include "analyzer/exact/slice_bound.hpp"

#include <algorithm>

#include "analyzer/exact/cap.hpp"
#include "analyzer/slice/slice.hpp"
#include "analyzer/slice/talk.hpp"

namespace pal::analyzer {
namespace {

bool within(const Requirement& requirement, Nanoseconds value) {
  return requirement.at_least ? value >= requirement.limit : value <= requirement.limit;
}

bool nearer(const Requirement& requirement, Nanoseconds value, const std::optional<Nanoseconds>& than) {
  return !than || (requirement.at_least ? value > *than : value < *than);
}

struct Attempt {
  std::size_t classes;
  ZoneGraph::Merging merging;
};

/// First as it is, then with fewer and larger classes.
constexpr Attempt attempts[] = {{100'000, ZoneGraph::Merging::within}, {400'000, ZoneGraph::Merging::hull}};

/// Classes in which the beginning of a skill is explored.
constexpr std::size_t most_of_beginning = 60'000;

bool is_loose_wait(const Problem& slice, const Step& step) {
  return step.kind == Step::Kind::wait && std::any_of(step.channels.begin(), step.channels.end(), [&](int c) {
           return slice.channels[static_cast<std::size_t>(c)].loose;
         });
}

/// The latest instant at which the whole problem is past `step`; nothing, if it was not found.
std::optional<Nanoseconds> latest(const Problem& problem, int step, const Limits& limits,
                                  Statistics& statistics) {
  const std::size_t all = problem.threads.size();
  Problem first = slice_of(problem,
                           {std::vector<bool>(all, true), std::vector<bool>(problem.devices.size(), true),
                            std::vector<bool>(problem.devices.size(), false)},
                           {true, true});
  Step past;
  past.kind = Step::Kind::complete;
  for (Step& each : first.steps) {
    if (each.kind == Step::Kind::complete) each.code = -1;
  }
  first.error_code = -1;
  for (int& next : first.steps[static_cast<std::size_t>(step)].next)
    next = static_cast<int>(first.steps.size());
  first.steps.push_back(past);
  Requirement until;
  until.measure = Requirement::Measure::duration;
  const SliceBound found = bound_in(first, until, cap_of(problem, 0), limits);
  statistics += found.statistics;
  return found.bound;
}

/// Says of waits at the beginning, for somebody who is left out, how long they last.
void limit_beginning(const Problem& problem, Problem& slice, const Limits& limits, Statistics& statistics) {
  const std::vector<ThreadTalk> talk = talk_of(problem);
  for (std::size_t t = 0; t < talk.size(); ++t) {
    const Thread& thread = slice.threads[t];
    if (thread.parent >= 0 || thread.left_out) continue;
    for (const int s : talk[t].beginning) {
      Step& step = slice.steps[static_cast<std::size_t>(s)];
      if (!is_loose_wait(slice, step)) continue;
      const auto found = latest(problem, s, limits, statistics);
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
  found.statistics.states = graph.places().size();
  found.statistics.classes = graph.classes().size();
  // The least interval is bounded whatever the others are.
  const bool grown = !watch.least && (graph.over_cap() || graph.never_answered() || graph.stuck() >= 0);
  if (found.complete && !grown && !graph.failure() && graph.peak().value >= 0)
    found.bound = graph.peak().value;
  return found;
}

SliceBound slice_bound(const Problem& problem, const Requirement& requirement, const Options& options,
                       std::size_t classes) {
  SliceBound best;
  const Cone cone = cone_of(problem, requirement);
  const Nanoseconds cap = cap_of(problem, requirement.limit);
  Workers workers(options.threads);
  for (const Relaxation relaxation : {Relaxation{true, true}, Relaxation{true, false}}) {
    Problem slice = slice_of(problem, cone, relaxation);
    limit_beginning(problem, slice, {std::min(classes, most_of_beginning), options.stop, {}, &workers},
                    best.statistics);
    for (const Attempt& attempt : attempts) {
      const SliceBound found =
          bound_in(slice, requirement, cap, {std::min(classes, attempt.classes), options.stop, {}, &workers},
                   attempt.merging);
      best.statistics += found.statistics;
      if (!found.complete) continue;
      best.complete = true;
      if (found.bound && nearer(requirement, *found.bound, best.bound)) best.bound = found.bound;
      break;
    }
    // With less that is loose there is more to explore.
    if (!best.complete || (best.bound && within(requirement, *best.bound))) break;
  }
  return best;
}

}  // namespace pal::analyzer
