#include "sim/val/transformation.hpp"

#include <cmath>
#include <cstdio>

namespace pal::sim::val {
namespace {

Eigen::Matrix3d zero_turn() {
  Eigen::Matrix3d m;
  m << 0, 1, 0, 0, 0, -1, -1, 0, 0;
  return m;
}

std::string column(double value, int decimals) {
  const double unit = std::pow(10.0, decimals);
  std::array<char, 32> text{};
  // + 0.0: no figure is shown as -0.
  std::snprintf(text.data(), text.size(), "%9.*f", decimals, std::round(value * unit) / unit + 0.0);
  return text.data();
}

}  // namespace

Pose pose_of(const Figures& figures) {
  Pose pose = Pose::Identity();
  pose.translation() = 1e-3 * Eigen::Vector3d(figures[0], figures[1], figures[2]);
  pose.linear() = Eigen::AngleAxisd(radians(figures[3]), Eigen::Vector3d::UnitZ()).toRotationMatrix() *
                  zero_turn() *
                  Eigen::AngleAxisd(radians(figures[4]), Eigen::Vector3d::UnitY()).toRotationMatrix() *
                  Eigen::AngleAxisd(radians(figures[5]), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

Figures figures_of(const Pose& pose, double upright) {
  const Eigen::Matrix3d r = pose.linear();
  const double cosine = std::hypot(r(0, 2), r(1, 2));
  const double a = std::atan2(-r(2, 2), cosine);
  const bool in_line = cosine < upright;
  const double o = in_line ? std::atan2(r(1, 1), r(0, 1)) : std::atan2(r(0, 2), -r(1, 2));
  const double t = in_line ? 0 : std::atan2(r(2, 1), -r(2, 0));
  const Eigen::Vector3d p = pose.translation() * 1e3;
  return {p.x(), p.y(), p.z(), degrees(o), degrees(a), degrees(t)};
}

Figures shown_figures(const Pose& pose) {
  return figures_of(pose, radians(0.01));
}

Figures val_joints(const Joints& q) {
  Figures shown{};
  for (std::size_t i = 0; i < joint_count; ++i) shown[i] = degrees(q[static_cast<Eigen::Index>(i)]);
  shown[1] -= 180;  // the same as + 180, in the machine's own range
  shown[2] += 180;
  return shown;
}

Joints joints_of(const Figures& shown) {
  Figures turned = shown;
  turned[1] += 180;
  turned[2] -= 180;
  Joints q;
  for (std::size_t i = 0; i < joint_count; ++i) q[static_cast<Eigen::Index>(i)] = radians(turned[i]);
  return q;
}

std::string columns(const Figures& figures) {
  std::string text;
  for (std::size_t i = 0; i < figures.size(); ++i) text += column(figures[i], i < 3 ? 2 : 3);
  return text;
}

std::string joint_columns(const Figures& figures) {
  std::string text;
  for (const double figure : figures) text += column(figure, 3);
  return text;
}

}  // namespace pal::sim::val
