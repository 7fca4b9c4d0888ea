#include "sim/arm/tool.hpp"

#include <array>

namespace pal::sim {
namespace {

constexpr std::array<const char*, 3> names{"pad", "gripper", "range-finder"};

}  // namespace

std::string to_string(ToolKind tool) {
  return names[static_cast<std::size_t>(tool)];
}

std::optional<ToolKind> parse_tool(std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return static_cast<ToolKind>(i);
  return std::nullopt;
}

Pose flange_to_tip_of(ToolKind tool) {
  switch (tool) {
    case ToolKind::gripper:
      return Pose(Eigen::Translation3d(0, 0, flange_to_grip));
    case ToolKind::range_finder:
      return Pose(Eigen::Translation3d(range_finder_x, 0, range_finder_z));
    case ToolKind::pad:
      break;
  }
  return pad_tool();
}

}  // namespace pal::sim
