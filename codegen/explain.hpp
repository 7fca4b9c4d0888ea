// What a skill will be at run time, for readers of its C++ or its traces.
#pragma once

#include <iosfwd>

#include "codegen/plan.hpp"

namespace pal::codegen {

/// Processors with their threads, servers, couriers, channels and devices, as text; the same for the same
/// plan. A server answers requests. A courier is a request that is on its way while its sender does something
/// else than wait for the answer (thesis, section 5.3.2).
void explain(const Plan& plan, std::ostream& out);

}  // namespace pal::codegen
