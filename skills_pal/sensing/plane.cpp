#include "skills_pal/sensing/plane.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pal::skills::sensing {
namespace {

constexpr int plane_rounds = 12;
constexpr double least_width = 1e-3;  // mm; of less no lean can be worked out
constexpr double degree = std::numbers::pi / 180;

// z = height + slope · (x, y): the errors lie along z, which is why not the distances from the plane are made
// small.
struct Fit {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  double width = 0;  // in the shorter direction, mm
  double flatness = 0;
  std::size_t points = 0;

  Eigen::Vector3d normal() const { return Eigen::Vector3d(-slope.x(), -slope.y(), 1).normalized(); }
  double off(const Eigen::Vector3d& point) const { return normal().dot(point - middle); }
};

// Through the points that lie within `thickness` of the plane before.
Fit fit_within(std::span<const Eigen::Vector3d> points, const Fit& before, double thickness) {
  const Eigen::Vector3d normal = before.normal();
  const auto counts = [&](const Eigen::Vector3d& point) {
    return std::abs(normal.dot(point - before.middle)) <= thickness;
  };
  Fit fit;
  for (const Eigen::Vector3d& point : points) {
    if (!counts(point)) continue;
    fit.middle += point;
    ++fit.points;
  }
  if (fit.points < 3) return fit;
  const auto count = static_cast<double>(fit.points);
  fit.middle /= count;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    if (!counts(point)) continue;
    const Eigen::Vector3d off = point - fit.middle;
    spread += off * off.transpose() / count;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> ground(spread.topLeftCorner<2, 2>().eval());
  fit.width = std::sqrt(12 * std::max(0.0, ground.eigenvalues()[0]));  // if they lie evenly
  if (fit.width < least_width) return fit;
  const Eigen::Vector2d lean = spread.topRightCorner<2, 1>();
  fit.slope = spread.topLeftCorner<2, 2>().inverse() * lean;
  fit.flatness = std::sqrt(std::max(0.0, spread(2, 2) - fit.slope.dot(lean))) * fit.normal().z();
  return fit;
}

}  // namespace

std::optional<Plane> find_plane(std::span<const Eigen::Vector3d> points, const PlaneOptions& options) {
  // From all points to those within the thickness, in halves: points of other things fall off one after the
  // other.
  Fit fit = fit_within(points, {}, std::numeric_limits<double>::infinity());
  double thickness = std::max(options.thickness, 3 * fit.flatness);
  for (int round = 0; round < plane_rounds && fit.points >= 3; ++round) {
    fit = fit_within(points, fit, thickness);
    thickness = std::max(options.thickness, thickness / 2);
  }
  const double least = std::max(static_cast<double>(options.least_points),
                                options.least_share * static_cast<double>(points.size()));
  if (static_cast<double>(fit.points) < least || fit.width < options.least_width) return std::nullopt;
  const Eigen::Vector3d normal = fit.normal();
  Plane plane;
  plane.standoff = normal.dot(fit.middle) / normal.z();
  // R_y(turn_y) R_x(turn_x) carries z to (cos x sin y, -sin x, cos x cos y): that is the normal.
  plane.turn_x = std::asin(std::clamp(-normal.y(), -1.0, 1.0)) / degree;
  plane.turn_y = std::atan2(normal.x(), normal.z()) / degree;
  plane.flatness = fit.flatness;
  plane.points = fit.points;
  return plane;
}

}  // namespace pal::skills::sensing
