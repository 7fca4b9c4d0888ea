#include "tests/unit/sensing/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pal::skills::sensing::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

double interpolated(double z, double z0, double e0, double z1, double e1) {
  return e0 * std::pow(e1 / e0, (z - z0) / (z1 - z0));
}

// As the range finder sees it: from the point before.
bool too_steep(const Corner& before, const Corner& here) {
  const double dy = here.y - before.y;
  const double dz = here.z - before.z;
  const double along = (dy * here.y + dz * here.z) / std::hypot(here.y, here.z);
  return std::abs(along) > std::hypot(dy, dz) * std::sin(75 * degree);
}

// The z of the nearest meeting of the ray with the pieces.
double first_meeting(const Outline& corners, double angle) {
  const double slope = std::tan(angle);  // the ray: y = slope · z
  double nearest = -1;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Corner& a = corners[i - 1];
    const Corner& b = corners[i];
    const double from = a.y - slope * a.z;
    const double to = b.y - slope * b.z;
    if (from * to > 0 || from == to) continue;
    const double z = a.z + (b.z - a.z) * from / (from - to);
    if (nearest < 0 || z < nearest) nearest = z;
  }
  return nearest;
}

}  // namespace

double stated_error(double z) {
  if (z <= 150) return 0.1;
  if (z <= 250) return interpolated(z, 150, 0.1, 250, 0.2);
  if (z <= 850) return interpolated(z, 250, 0.2, 850, 2);
  return interpolated(z, 850, 2, 1000, 20);
}

Shape outline(Outline corners) {
  return [corners = std::move(corners)](double angle) { return first_meeting(corners, angle); };
}

Shape plane(const Eigen::Vector3d& normal, double distance, const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d seen = pose.linear().transpose() * normal.normalized();
  const double away = distance - normal.normalized().dot(pose.translation());
  return [seen, away](double angle) { return away / (seen.y() * std::tan(angle) + seen.z()); };
}

Scan scan(const Shape& shape, std::mt19937& random, double errors) {
  std::normal_distribution<double> normal;
  Scan result;
  Corner before{0, -1};
  bool steep_before = false;
  for (std::size_t i = 0; i < most_points; ++i) {
    const double angle = (-20 + 40 * static_cast<double>(i) / (most_points - 1)) * degree;
    const double exact = shape(angle);
    result.valid[i] = exact >= 100 && exact <= 1000;
    const Corner here{exact * std::tan(angle), exact};
    const bool steep = before.z > 0 && exact > 0 && too_steep(before, here);
    const bool onto_nearer = steep && !steep_before && here.z < before.z;
    if (steep && !onto_nearer) result.valid[i] = false;
    before = here;
    steep_before = steep;
    if (!result.valid[i]) continue;
    const double limit = errors * stated_error(exact);
    const double z = exact + std::clamp(limit / 2 * normal(random), -limit, limit);
    result.z[i] = std::round(z * 10) / 10;
    result.y[i] = std::round(z * std::tan(angle) * 10) / 10;
  }
  return result;
}

}  // namespace pal::skills::sensing::test
