// The greatest fraction of time, in the long run, that some unending run keeps a processor busy.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analyzer/load/fraction.hpp"
#include "analyzer/problem/problem.hpp"
#include "analyzer/runs/witness.hpp"
#include "analyzer/verdict/verdict.hpp"
#include "analyzer/zones/zone_graph.hpp"

namespace pal::analyzer {

struct LoadBound {
  /// No unending run keeps the processor busier. If a run attains it, work and time are those of a turn of
  /// that run; otherwise it is only a fraction.
  Fraction most{1, 1};
  bool proved = false;             // otherwise `most` is only what is always true
  Fraction shown{0, 1};            // a run keeps the processor so busy
  std::optional<Witness> witness;  // that run, unless it has no load: its beginning and its first turns
  bool exact = false;              // it attains `most`
  std::size_t states = 0;
};

/// Whether every run ends, so that there is no long run in which a processor has a load. False proves
/// nothing. `graph` as for load_bounds().
bool ends_always(const Problem& problem, const ZoneGraph& graph);

/// One bound a processor. `graph`: all classes of `machine`, which watches nothing, with its edges, explored
/// to the end.
std::vector<LoadBound> load_bounds(const Machine& machine, const ZoneGraph& graph,
                                   const std::vector<ProcessorId>& processors, const Limits& limits);

/// Whether each of `processors` keeps a limit: by shares of the time, by runs, and by a grid that is not much
/// larger than `graph`. Cheaper than bounds, and sometimes undecided where these would decide. `graph` as for
/// load_bounds().
struct LoadDecision {
  VerdictState state = VerdictState::undecided;
  Fraction load;                   // holds: no run exceeds it; fails: a run attains it
  std::optional<Witness> witness;  // fails: that run
};
LoadDecision decide_loads(const Machine& machine, const ZoneGraph& graph,
                          const std::vector<ProcessorId>& processors, const Fraction& limit,
                          const Limits& limits);

}  // namespace pal::analyzer
