// Whether a value that grows beyond all that is followed ever counts.
#pragma once

#include <optional>

#include "analyzer/problem/problem.hpp"
#include "analyzer/runs/witness.hpp"
#include "analyzer/verdict/verdict.hpp"
#include "analyzer/zones/zone_graph.hpp"

namespace pal::analyzer {

enum class Growth {
  ends,    // in every run: with the skill, or what was awaited is withdrawn; no value is measured beyond the
           // cap
  counts,  // in some run it is measured in the end, or grows for ever
  open     // the limits do not suffice to tell
};

struct GrowthSearch {
  Growth growth = Growth::open;
  /// If it counts: a run in which the value is greater than the limit, measured in the end or on a way that
  /// goes round for ever. None, if no replay confirmed it.
  std::optional<Witness> witness;
  Statistics statistics;
};

/// Of what `watch` watches, beyond `cap`. Among classes that hold all that lies within them a way round need
/// be none of runs. Among classes that are merged only with their equals it is: each point of such a class
/// has one before it on the way, and there are finitely many whole points.
GrowthSearch growth(const Problem& problem, const Watch& watch, Nanoseconds cap, const Limits& limits);

}  // namespace pal::analyzer
