// In which threads an executed module runs.
#pragma once

#include "codegen/plan.hpp"

namespace pal::codegen {

/// Fills PlannedModule::runners.
void find_runners(Plan& plan);

}  // namespace pal::codegen
