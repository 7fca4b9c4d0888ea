// Sums of times that may have no bound.
#pragma once

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer::compositional {

constexpr Nanoseconds never = Range::unbounded;

/// Saturates at `never`.
inline Nanoseconds plus(Nanoseconds a, Nanoseconds b) {
  return a >= never - b ? never : a + b;
}

/// Work of `jobs` jobs. Saturates at `never`.
inline Nanoseconds work_of(Nanoseconds jobs, Nanoseconds cost) {
  Nanoseconds work = 0;
  return __builtin_mul_overflow(jobs, cost, &work) || work > never ? never : work;
}

}  // namespace pal::analyzer::compositional
