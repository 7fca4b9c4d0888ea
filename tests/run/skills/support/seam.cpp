#include "tests/run/skills/support/seam.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pal::test {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double middle_x = 500, middle_y = -200, top = -181.8 + 40;
constexpr double height = 8, length = 200, swing = 10;

double fall() {
  return std::tan(15 * degree);
}
double ridge(double x) {
  return height / 2 * std::sin(2 * std::numbers::pi * x / length);
}
double seam(double x) {
  return swing * std::sin(2 * std::numbers::pi * x / (1.7 * length));
}

}  // namespace

Seam::Seam() {
  for (double x = -150; x <= 150; x += 0.5) highest_ = std::max(highest_, ridge(x));
}

Eigen::Vector3d Seam::edge(double x) const {
  return {x, middle_y + seam(x - middle_x), top + ridge(x - middle_x) - highest_};
}

Eigen::Vector3d Seam::along(double x) const {
  return (edge(x + 0.01) - edge(x - 0.01)).normalized();
}

Eigen::Vector3d Seam::normal(double x) const {
  const double bend = (seam(x - middle_x + 0.01) - seam(x - middle_x - 0.01)) / 0.02;
  const double rise = (ridge(x - middle_x + 0.01) - ridge(x - middle_x - 0.01)) / 0.02;
  return Eigen::Vector3d(-(rise + fall() * bend), fall(), 1).normalized();
}

OffSeam off(const Seam& seam, const sim::Sample& sample, double standoff) {
  const Eigen::Vector3d tip = sample.tool * 1e3;
  const Eigen::Matrix3d tool = sample.tool_turn.toRotationMatrix();
  double x = tip.x();
  for (int i = 0; i < 20; ++i) x -= (seam.edge(x) - tip).dot(tool.col(0)) / seam.along(x).dot(tool.col(0));
  const Eigen::Vector3d seen = tool.transpose() * (seam.edge(x) - tip);
  Eigen::Matrix3d wanted;
  const Eigen::Vector3d depth = -seam.normal(x);
  wanted << seam.along(x), depth.cross(seam.along(x)), depth;
  return {std::hypot(seen.y(), seen.z() - standoff),
          Eigen::AngleAxisd(Eigen::Matrix3d(tool.transpose() * wanted)).angle() / degree};
}

}  // namespace pal::test
