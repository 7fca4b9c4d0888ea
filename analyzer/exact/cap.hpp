// Up to where an exploration follows what it measures.
#pragma once

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// Sums of two such values stay below what counts as unbounded.
constexpr Nanoseconds most_cap = Range::unbounded / 4;

/// More than any value that is not growing without end is likely to be: a few times all that the problem says
/// of time.
Nanoseconds cap_of(const Problem& problem, Nanoseconds limit);

}  // namespace pal::analyzer
