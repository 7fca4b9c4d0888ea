#include "sim/controller/correction.hpp"

namespace pal::sim {

Pose corrected(const Pose& pose, const Correction& correction, CorrectionFrame frame, const Pose& opened) {
  constexpr double metres = 1e-3;
  const Eigen::Vector3d shift = Eigen::Vector3d(correction.dx, correction.dy, correction.dz) * metres;
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(radians(correction.rz), Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(radians(correction.ry), Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(radians(correction.rx), Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  Eigen::Matrix3d reference = Eigen::Matrix3d::Identity();
  if (frame == CorrectionFrame::tool) reference = pose.linear();
  if (frame == CorrectionFrame::tool_at_open) reference = opened.linear();

  Pose result = pose;
  result.translation() += reference * shift;
  // Rounding must not add up over thousands of corrections: the rotation is made one again by its quaternion.
  const Eigen::Matrix3d turned = reference * turn * reference.transpose() * pose.linear();
  result.linear() = Eigen::Quaterniond(turned).normalized().toRotationMatrix();
  return result;
}

}  // namespace pal::sim
