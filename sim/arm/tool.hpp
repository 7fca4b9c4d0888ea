// What the arm can carry behind its force-torque sensor.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/arm/kinematics.hpp"

namespace pal::sim {

enum class ToolKind {
  pad,           // a rubber tip on a spring, to press and rub with
  gripper,       // two fingers that close along the tool's y axis
  range_finder,  // the laser range finder, which is not meant to touch anything
};

/// "pad", "gripper", "range-finder".
std::string to_string(ToolKind tool);
std::optional<ToolKind> parse_tool(std::string_view name);

/// From the flange to the tip: the pad's end, the middle between the finger pads, the range finder's origin.
Pose flange_to_tip_of(ToolKind tool);

/// Between the finger pads when the gripper is open, mm.
inline constexpr double gripper_opening = 80;

/// The range finder's origin from the flange, m (thesis, appendix F.2).
inline constexpr double range_finder_x = 0.049;
inline constexpr double range_finder_z = 0.197;

/// From the flange to the middle between the finger pads, m.
inline constexpr double flange_to_grip = 0.145;

}  // namespace pal::sim
