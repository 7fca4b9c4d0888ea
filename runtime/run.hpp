// One run of one skill.
#pragma once

#include <vector>

#include "pal/runtime/outcome.hpp"
#include "pal/runtime/skill.hpp"
#include "runtime/kernel/devices.hpp"

namespace pal::runtime {

/// Runs the skill to its end, in the kind of time that the options ask for. All devices are closed then,
/// however it ended. `connections`: one for each device of the skill's wiring, in its order.
Outcome run(Skill& skill, World& world, const std::vector<Connection>& connections,
            const RunOptions& options);

}  // namespace pal::runtime
