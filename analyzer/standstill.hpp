// Runs in which no time passes any more although things go on happening.
#pragma once

#include <optional>

#include "analyzer/exact.hpp"
#include "analyzer/zone_graph.hpp"

namespace pal::analyzer {

/// A way round on which nothing can take any time, if a run gets to one and `limits` suffice to find it.
/// Costs next to nothing where each loop of each thread takes some time.
std::optional<Standstill> standstill(const Problem& problem, const Limits& limits);

}  // namespace pal::analyzer
