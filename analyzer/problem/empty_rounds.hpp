// Loops round blocks that have nothing to do.
#pragma once

#include "analyzer/problem/problem.hpp"
#include "pal/support/diagnostic.hpp"

namespace pal::analyzer {

/// PAL0729 for each loop that goes round nothing but a CONCURRENT which is over as soon as it begins.
void report_empty_rounds(const Problem& problem, Diagnostics& diagnostics);

}  // namespace pal::analyzer
