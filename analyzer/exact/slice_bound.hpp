// What exploring less than the whole problem proves of a requirement.
#pragma once

#include <optional>

#include "analyzer/exact/exact.hpp"
#include "analyzer/zones/zone_graph.hpp"

namespace pal::analyzer {

struct SliceBound {
  /// No run of the whole problem exceeds it (falls below it, if the least is asked for). Nothing: none was
  /// found within the limits.
  std::optional<Nanoseconds> bound;
  bool complete = false;  // all runs of the slice were seen
  bool beyond = false;    // some value is greater than the cap
  Statistics statistics;
};

/// Of all runs of `slice`, values up to `cap`.
SliceBound bound_in(const Problem& slice, const Requirement& requirement, Nanoseconds cap,
                    const Limits& limits, ZoneGraph::Merging merging = ZoneGraph::Merging::within);

/// Of a timed requirement (no load, no busy period). In at most `classes`, with Options::stop.
SliceBound slice_bound(const Problem& problem, const Requirement& requirement, const Options& options,
                       std::size_t classes);

}  // namespace pal::analyzer
