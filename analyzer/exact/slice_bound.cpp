#include "analyzer/exact/slice_bound.hpp"

#include <algorithm>

#include "analyzer/exact/cap.hpp"
#include "analyzer/slice/slice.hpp"
#include "analyzer/zones/zone_graph.hpp"

namespace pal::analyzer {
namespace {

/// What the zone graph of a slice says of all its runs; nothing, if that is no bound.
std::optional<Nanoseconds> bound_in(const ZoneGraph& graph) {
  const bool open = graph.failure() || graph.over_cap() || graph.never_answered() || graph.stuck() >= 0;
  if (open || graph.peak().value < 0) return std::nullopt;
  return graph.peak().value;
}

}  // namespace

SliceBound slice_bound(const Problem& problem, const Requirement& requirement, const Options& options,
                       std::size_t classes) {
  SliceBound found;
  const Cone cone = cone_of(problem, requirement);
  Workers workers(options.threads);
  for (const Looseness looseness : {Looseness{true, true}, Looseness{true, false}}) {
    const Problem slice = slice_of(problem, cone, looseness);
    const Watch watch = watch_of(slice, requirement);
    const Machine machine(slice, watch);
    ZoneGraph graph(machine, cap_of(problem, requirement.limit), false);
    const bool complete = graph.explore({classes, options.stop, {}, &workers});
    found.statistics.states += graph.places().size();
    found.statistics.classes += graph.classes().size();
    if (options.stop && options.stop()) break;
    // With less that is loose there is more to explore.
    if (!complete) break;
    const std::optional<Nanoseconds> bound = bound_in(graph);
    if (!bound) continue;
    const bool nearer = !found.bound || (watch.least ? *bound > *found.bound : *bound < *found.bound);
    if (nearer) found.bound = bound;
    if (watch.least ? *bound >= requirement.limit : *bound <= requirement.limit) break;
  }
  return found;
}

}  // namespace pal::analyzer
