// One run of one skill.
#pragma once

#include <vector>

#include "pal/runtime/outcome.hpp"
#include "pal/runtime/skill.hpp"
#include "runtime/devices.hpp"

namespace pal::runtime {

/// Runs the skill to its end, in the time that the options ask for; all devices are closed then, whatever the
/// end was. `connections`: one for each device of the skill's wiring, in its order.
Outcome run(Skill& skill, World& world, const std::vector<Connection>& connections,
            const RunOptions& options);

}  // namespace pal::runtime
