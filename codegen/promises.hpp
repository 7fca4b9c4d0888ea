// The requirements that a run is compared with, and the parties that the proof of each relies on.
#pragma once

#include "codegen/plan.hpp"
#include "pal/pan/network.hpp"

namespace pal::codegen {

/// Fills Plan::requirements. `network` is the plan's; everything else of the plan is there.
void plan_requirements(const pan::Network& network, Plan& plan);

}  // namespace pal::codegen
