// Runs in which no time passes any more although things go on happening.
#pragma once

#include <optional>

#include "analyzer/exact/exact.hpp"
#include "analyzer/zones/zone_graph.hpp"

namespace pal::analyzer {

struct StandstillSearch {
  /// A way round on which nothing can take any time, that some run gets to.
  std::optional<Standstill> found = {};
  /// None was found because there is none; otherwise a search with wider limits may find one.
  bool excluded = false;
};

/// Costs next to nothing where each loop of each thread takes some time.
StandstillSearch standstill(const Problem& problem, const Limits& limits);

}  // namespace pal::analyzer
