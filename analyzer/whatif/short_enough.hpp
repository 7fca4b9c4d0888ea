// How short one time must become for a requirement to hold.
#pragma once

#include <string>
#include <vector>

#include "analyzer/exact/exact.hpp"
#include "analyzer/whatif/figures.hpp"
#include "analyzer/whatif/ids.hpp"

namespace pal::analyzer::whatif {

/// A time with which a requirement holds that does not as things are. All others stay as they are.
struct ShortEnough {
  RequirementId requirement;
  std::string figure;
  Interval time;    // as it is
  Interval enough;  // with it the requirement was proved to hold, and with it all that holds as things are
};

/// Looks at each requirement that does not hold, and at each figure of the environment by itself. First the
/// worst time becomes shorter, down to the best. If that does not suffice, both become 0, and then the worst
/// one as long as it may be. The worst times are looked for with three digits. `before`: the verdicts as
/// things are, by RequirementId. A requirement that says nothing with the shorter time does not count as one
/// that holds.
std::vector<ShortEnough> short_enough_times(const pan::Network& network, const pan::Environment& environment,
                                            const std::vector<Verdict>& before, const Options& options);

}  // namespace pal::analyzer::whatif
