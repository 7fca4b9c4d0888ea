// One change that is tried: what it may take, and how far off everything is with it.
#pragma once

#include <cstddef>
#include <vector>

#include "analyzer/analysis.hpp"

namespace pal::analyzer::whatif {

/// The options, for so many seconds from now at most.
Options within(const Options& given, double seconds);

/// By all analyses, for so many seconds at most.
std::vector<Verdict> verdicts_on(const Problem& problem, const Options& options, std::size_t classes,
                                 double seconds);

/// How far off all requirements are together, in limits; 0: all hold. What says nothing after a change, and
/// said nothing `before`, is no fault of the change. Both by RequirementId.
double missed(const std::vector<Verdict>& after, const std::vector<Verdict>& before);

}  // namespace pal::analyzer::whatif
