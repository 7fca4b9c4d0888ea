// How far an exploration follows the values that it measures.
#pragma once

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// Sums of two such values stay below what counts as unbounded.
constexpr Nanoseconds most_cap = Range::unbounded / 4;

/// More than a value is likely to reach unless it grows without end: a few times the sum of all times of the
/// problem.
Nanoseconds cap_of(const Problem& problem, Nanoseconds limit);

}  // namespace pal::analyzer
