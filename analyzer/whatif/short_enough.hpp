// How short one time must become for everything to hold.
#pragma once

#include <string>
#include <vector>

#include "analyzer/exact/exact.hpp"
#include "analyzer/whatif/figures.hpp"

namespace pal::analyzer {

/// A time that alone makes everything hold, all others as they are.
struct ShortEnough {
  std::string figure;
  Interval time;    // as it is
  Interval enough;  // with it everything was proved to hold
};

/// Looks at each figure of the environment by itself. First its worst time becomes shorter, down to the best.
/// If that does not suffice, both become 0, and then the worst one as long as it may be. The worst times are
/// looked for with three digits. `before`: the verdicts as things are, by RequirementId; not all hold.
/// A requirement that says nothing only with the shorter time counts as one that does not hold.
std::vector<ShortEnough> short_enough_times(const pan::Network& network, const pan::Environment& environment,
                                            const std::vector<Verdict>& before, const Options& options);

}  // namespace pal::analyzer
