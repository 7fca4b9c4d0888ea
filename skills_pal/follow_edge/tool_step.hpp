// A motion of one ALTER cycle as a change of the tool's pose.
#pragma once

#include <Eigen/Geometry>
#include <numbers>

namespace pal::skills {

inline constexpr double degree = std::numbers::pi / 180;

/// mm and degrees along and about the tool's axes as they were before: x first, then y, then z, as ALTER
/// takes it. `Motion` is the message.
template <class Motion>
Eigen::Isometry3d moved_by(const Motion& motion) {
  Eigen::Isometry3d step = Eigen::Isometry3d::Identity();
  step.translation() = Eigen::Vector3d(motion.dx, motion.dy, motion.dz);
  step.linear() = (Eigen::AngleAxisd(motion.rz * degree, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(motion.ry * degree, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(motion.rx * degree, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return step;
}

}  // namespace pal::skills
