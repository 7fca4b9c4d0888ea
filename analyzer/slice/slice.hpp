// A problem with fewer parts that has all runs of the whole one, and more: what no run of it exceeds no run
// of the whole exceeds (docs/internals/slices.md).
#pragma once

#include "analyzer/slice/cone.hpp"

namespace pal::analyzer {

/// What is given up so that there is less to explore.
struct Looseness {
  bool conditions = false;  // each read of a condition gives any value, but where its sets say which
  bool periods = false;     // an event that comes every T comes no sooner than T after the one before
};

/// Threads, steps, channels, devices and conditions keep their numbers; what is left out is there and does
/// nothing. A block that is left out begins, lasts and is stopped on a processor of its own, and takes for
/// all of it as long as it likes.
Problem slice_of(const Problem& problem, const Cone& cone, Looseness looseness);

}  // namespace pal::analyzer
