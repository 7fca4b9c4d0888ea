// A problem with fewer parts that has all runs of the whole one, and more. So a bound of its runs is a bound
// of the runs of the whole problem (docs/internals/slices.md).
#pragma once

#include "analyzer/slice/cone.hpp"

namespace pal::analyzer {

/// Which details are given up to make the slice smaller to explore.
struct Relaxation {
  bool conditions = false;  // each read of a condition gives any value, but where its sets say which
  bool periods = false;     // an event that comes every T comes no sooner than T after the one before
};

/// Threads, steps, channels, devices and conditions keep their numbers; left-out parts stay in the lists and
/// do nothing. A block that is left out begins, lasts and is stopped on a processor of its own, and each of
/// these may take any time.
Problem slice_of(const Problem& problem, const Cone& cone, Relaxation relaxation);

}  // namespace pal::analyzer
