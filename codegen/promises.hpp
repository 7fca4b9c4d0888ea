// What a run is measured against: the requirements, and on whom the proof of each relies.
#pragma once

#include "codegen/plan.hpp"
#include "pal/pan/network.hpp"

namespace pal::codegen {

/// Fills Plan::requirements. `network` is the plan's; everything else of the plan is there.
void plan_requirements(const pan::Network& network, Plan& plan);

}  // namespace pal::codegen
