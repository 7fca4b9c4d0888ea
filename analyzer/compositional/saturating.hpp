// Sums of times that may have no bound.
#pragma once

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer::compositional {

constexpr Nanoseconds never = Range::unbounded;

/// Saturates at `never`.
inline Nanoseconds plus(Nanoseconds a, Nanoseconds b) {
  return a >= never - b ? never : a + b;
}

}  // namespace pal::analyzer::compositional
