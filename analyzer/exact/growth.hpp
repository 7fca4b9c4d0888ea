// Whether a value counts that grows beyond the cap.
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
  /// If it counts: a run in which the value is greater than the limit. It is measured in the end, or grows on
  /// a cycle for ever. None if no replay confirmed it.
  std::optional<Witness> witness;
  Statistics statistics;
};

/// For what `watch` watches, beyond `cap`. If classes are merged with larger ones, a cycle of classes need
/// not be a cycle of runs. If they are merged only with their equals, it is one. Each point of such a class
/// has a predecessor on the cycle, and whole points are finitely many.
GrowthSearch growth(const Problem& problem, const Watch& watch, Nanoseconds cap, const Limits& limits);

}  // namespace pal::analyzer
