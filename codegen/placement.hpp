// Which processor each thread runs on.
#pragma once

#include <vector>

#include "codegen/plan.hpp"

namespace pal::codegen {

/// Fills processor and priority. A block that is not placed runs where the body of its module does. Reports
/// threads that are nowhere.
void place_threads(const pan::Environment& environment, Diagnostics& diagnostics,
                   std::vector<PlannedThread>& threads);

}  // namespace pal::codegen
