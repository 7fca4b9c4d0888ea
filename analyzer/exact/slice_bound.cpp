#include "analyzer/exact/slice_bound.hpp"

#include <algorithm>

#include "analyzer/exact/cap.hpp"
#include "analyzer/slice/slice.hpp"

namespace pal::analyzer {
namespace {

bool within(const Requirement& requirement, Nanoseconds value) {
  return requirement.at_least ? value >= requirement.limit : value <= requirement.limit;
}

bool nearer(const Requirement& requirement, Nanoseconds value, const std::optional<Nanoseconds>& than) {
  return !than || (requirement.at_least ? value > *than : value < *than);
}

}  // namespace

SliceBound bound_in(const Problem& slice, const Requirement& requirement, Nanoseconds cap,
                    const Limits& limits) {
  const Watch watch = watch_of(slice, requirement);
  const Machine machine(slice, watch);
  ZoneGraph graph(machine, cap, false);
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
    const SliceBound found = bound_in(slice_of(problem, cone, looseness), requirement, cap,
                                      {classes, options.stop, {}, &workers});
    best.statistics += found.statistics;
    // With less that is loose there is more to explore.
    if (!found.complete) break;
    best.complete = true;
    if (!found.bound) continue;
    if (nearer(requirement, *found.bound, best.bound)) best.bound = found.bound;
    if (within(requirement, *found.bound)) break;
  }
  return best;
}

}  // namespace pal::analyzer
