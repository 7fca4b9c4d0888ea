// The parts of a bound (`pal check --explain`, the notes of PAL0890), read off the run that shows it: what
// the time was spent on.
#pragma once

#include <vector>

#include "analyzer/verdict/verdict.hpp"

namespace pal::analyzer {

/// Pieces of time without gaps, from the birth of what the witness measures to its use. Each has the actor,
/// what it did, and the line where that stands. They add up to the value. Nothing for a loss or a load, which
/// are not times.
std::vector<Reason> reasons(const Problem& problem, const Requirement& requirement, const Witness& witness);

}  // namespace pal::analyzer
