#include "sim/cell/device_views.hpp"

namespace pal::sim {

GripperState gripper_state(const Workcell& workcell) {
  return {workcell.gripper_width(), workcell.gripper_force(), workcell.holds_part()};
}

RangeView range_view(const Workcell& workcell) {
  return {[&workcell] { return workcell.tool(); },
          [&workcell](const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
            return workcell.cast(origin, direction);
          }};
}

}  // namespace pal::sim
