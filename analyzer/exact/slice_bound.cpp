#include "analyzer/exact/slice_bound.hpp"

#include <algorithm>
#include <set>

#include "analyzer/exact/cap.hpp"
#include "analyzer/problem/flow.hpp"
#include "analyzer/slice/slice.hpp"

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

/// Steps of a thread that come at most once in a skill's life, before it comes to a round or starts blocks.
std::vector<bool> beginning_of(const Problem& problem, const Thread& thread) {
  std::vector<bool> made(problem.steps.size());
  if (thread.parent >= 0 || thread.left_out) return made;
  const std::set<int> all = steps_of(problem, thread);
  for (const int s : all) made[static_cast<std::size_t>(s)] = true;
  for (const int s : all) {
    const bool starts = problem.steps[static_cast<std::size_t>(s)].kind == Step::Kind::fork;
    if (!starts && !comes_back(problem, s)) continue;
    follow(problem, {s}, [&made](int at) {
      made[static_cast<std::size_t>(at)] = false;
      return Course::goes_on;
    });
  }
  return made;
}

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
  for (const Thread& thread : slice.threads) {
    const std::vector<bool> once = beginning_of(slice, thread);
    for (std::size_t s = 0; s < once.size(); ++s) {
      if (!once[s] || !is_loose_wait(slice, slice.steps[s])) continue;
      const auto found = latest(problem, static_cast<int>(s), limits, statistics);
      if (!found) break;
      slice.steps[s].arrival.worst = std::max(*found, slice.steps[s].arrival.best);
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
  for (const Looseness looseness : {Looseness{true, true}, Looseness{true, false}}) {
    Problem slice = slice_of(problem, cone, looseness);
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
