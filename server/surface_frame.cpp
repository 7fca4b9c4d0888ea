#include "server/surface_frame.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace pal::server {
namespace {

constexpr double least_apart = 0.005;                        // m
constexpr double least_angle = 10 * std::numbers::pi / 180;  // of the plane's two directions

Eigen::Vector3d place(const ScenePose& pose) {
  return Eigen::Vector3d(pose.position.data());
}

}  // namespace

std::optional<ScenePose> surface_frame(const ScenePose& origin, const ScenePose& along,
                                       const ScenePose& beside) {
  const Eigen::Vector3d to_along = place(along) - place(origin), to_beside = place(beside) - place(origin);
  if (to_along.norm() < least_apart || to_beside.norm() < least_apart) return std::nullopt;
  const Eigen::Vector3d x = to_along.normalized();
  Eigen::Vector3d z = x.cross(to_beside.normalized());
  if (z.norm() < std::sin(least_angle)) return std::nullopt;
  z.normalize();
  const Eigen::Vector3d towards = Eigen::Quaterniond(origin.turn.data()) * Eigen::Vector3d::UnitZ();
  if (z.dot(towards) < 0) z = -z;
  Eigen::Matrix3d axes;
  axes << x, z.cross(x), z;
  const Eigen::Quaterniond turn(axes);
  return ScenePose{origin.position, {turn.x(), turn.y(), turn.z(), turn.w()}};
}

}  // namespace pal::server
