// From a cycle of a slice to an unending run of the whole skill.
#pragma once

#include <optional>
#include <vector>

#include "analyzer/load/grid.hpp"
#include "analyzer/runs/witness.hpp"

namespace pal::analyzer {

/// Tries to find a run of the whole skill that goes round `cycle` (edges of `grid`) for ever. It has a real
/// beginning. Then it follows the cycle, while the parts that the slice leaves out go on beside it. It ends
/// when everything is exactly as it was at an earlier turn. The witness is the beginning and the first turns.
std::optional<Witness> unending_run(const Machine& machine, const ZoneGraph& graph,
                                    const Recurrence& recurrence, const Slice& slice, const Grid& grid,
                                    const std::vector<int>& cycle);

}  // namespace pal::analyzer
