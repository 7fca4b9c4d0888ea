// Why a bound is what it is, read off its witness.
#pragma once

#include <string>
#include <vector>

#include "analyzer/verdict.hpp"

namespace pal::analyzer {

/// What the time of the witness's measurement was spent on, piece by piece without gaps.
std::vector<Reason> reasons(const Problem& problem, const Requirement& requirement, const Witness& witness);

/// A verdict on an age or response in words. `verdict.witness` and `verdict.reasons` stand already.
std::string explanation(const Problem& problem, const Requirement& requirement, const Verdict& verdict);

/// Why nothing is measured in any run. `passed`: what is watched does happen.
std::string nothing_measured(const Requirement& requirement, bool passed);

/// "27.95 ms", exact.
std::string milliseconds(Nanoseconds time);

}  // namespace pal::analyzer
