// The greatest fraction of time, in the long run, that some unending run keeps a processor busy.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analyzer/problem.hpp"
#include "analyzer/witness.hpp"
#include "analyzer/zone_graph.hpp"

namespace pal::analyzer {

/// Work in every `time`; work <= time, time > 0.
struct Fraction {
  Nanoseconds work = 0;
  Nanoseconds time = 1;
};

bool greater(const Fraction& a, const Fraction& b);

struct LoadBound {
  Fraction most{1, 1};             // no unending run keeps the processor busier
  bool proved = false;             // otherwise `most` is only what is always true
  bool exact = false;              // a run attains it
  std::optional<Witness> witness;  // that run: up to the repetition, and once through it
  std::size_t states = 0;
};

/// Nanoseconds of work in a second, rounded up.
Nanoseconds per_second(const Fraction& fraction);

/// One bound a processor. `graph`: all classes of `machine`, which watches nothing, with its edges, explored
/// to the end.
std::vector<LoadBound> load_bounds(const Machine& machine, const ZoneGraph& graph,
                                   const std::vector<int>& processors, const Limits& limits);

}  // namespace pal::analyzer
