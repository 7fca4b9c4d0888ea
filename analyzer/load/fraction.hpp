// Parts of time.
#pragma once

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// Work in every `time`; 0 <= work <= time, time > 0.
struct Fraction {
  Nanoseconds work = 0;
  Nanoseconds time = 1;
};

bool greater(const Fraction& a, const Fraction& b);

/// Nanoseconds of work in a second, rounded up.
Nanoseconds per_second(const Fraction& fraction);

}  // namespace pal::analyzer
