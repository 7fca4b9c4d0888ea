// Which processor each thread runs on.
#pragma once

#include <vector>

#include "codegen/plan.hpp"

namespace pal::codegen {

/// Fills processor and priority. A block that is not placed runs where its module does, and one of a module
/// that is run by Execute where the module that executes it does. Reports threads that are nowhere.
void place_threads(const pan::Network& network, const pan::Environment& environment, Diagnostics& diagnostics,
                   std::vector<PlannedThread>& threads);

}  // namespace pal::codegen
