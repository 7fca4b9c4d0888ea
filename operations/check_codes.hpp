// What becomes of the codes with which icons end, and which codes come to a CASE.
#pragma once

#include "operations/check.hpp"
#include "operations/codes.hpp"
#include "operations/graph.hpp"

namespace pal::operations {

/// Reports codes that no icon handles, and those that a CASE forgot (PAL1006); ways of a CASE that are never
/// taken (PAL1016). `codes`: of possible_codes(), complete.
void check_codes(const Graph& graph, Place at, const Skills& skills, const PossibleCodes& codes,
                 Diagnostics& diagnostics);

}  // namespace pal::operations
