// What emulated devices see of the physics.
#pragma once

#include "sim/devices/gripper_emulator.hpp"
#include "sim/devices/range_finder_emulator.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

GripperState gripper_state(const Workcell& workcell);
/// From the tool's tip, which is the range finder's origin if the tool is the range finder. The workcell
/// outlives it.
RangeView range_view(const Workcell& workcell);

}  // namespace pal::sim
