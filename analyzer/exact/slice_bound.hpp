// What is proved of a requirement by exploring less than the whole problem.
#pragma once

#include <optional>

#include "analyzer/exact/exact.hpp"

namespace pal::analyzer {

struct SliceBound {
  /// No run of the whole problem exceeds it (falls below it, if the least is asked for). Nothing: none was
  /// found within the limits.
  std::optional<Nanoseconds> bound;
  Statistics statistics;
};

/// Of a timed requirement (no load, no busy period). In at most `classes`, with Options::stop.
SliceBound slice_bound(const Problem& problem, const Requirement& requirement, const Options& options,
                       std::size_t classes);

}  // namespace pal::analyzer
