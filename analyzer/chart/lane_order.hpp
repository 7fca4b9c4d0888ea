// In which order lanes stand under each other.
#pragma once

#include <cstddef>
#include <vector>

#include "analyzer/chart/timeline.hpp"

namespace pal::analyzer::chart {

/// A permutation of the lanes: order[i] is the index of the lane that is drawn i-th. Lanes of one processor
/// stand together, and a device stands alone. The order makes the arrows shortest, where each pair of lanes
/// that talk counts once. Of several such orders it is the one nearest to that of the trace.
std::vector<std::size_t> lane_order(const Timeline& timeline);

}  // namespace pal::analyzer::chart
