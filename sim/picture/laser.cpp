#include "sim/picture/laser.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/arm/puma.hpp"

namespace pal::sim {
namespace {

// As the range finder's (docs/workcell/range-finder.md).
constexpr int count = 255;
constexpr double half_fan = radians(20);
constexpr double nearest_valid = 100, farthest_valid = 1000;  // mm

constexpr Colour beam{1.0, 0.15, 0.10, 0.25};
constexpr Colour line{1.0, 0.05, 0.02, 1.0};

}  // namespace

std::optional<double> Laser::nearest() const {
  if (points.empty()) return std::nullopt;
  return std::min_element(points.begin(), points.end(),
                          [](const Point& a, const Point& b) { return a.away < b.away; })
      ->away;
}

Laser laser_of(const Stage& stage) {
  // As Workcell::cast: neither the arm nor what is felt and not seen.
  static constexpr std::array<mjtByte, mjNGROUP> groups{1, 0, 1, 0, 1, 1};
  Laser laser;
  const Eigen::Vector3d origin = stage.tip();
  for (int i = 0; i < count; ++i) {
    const double angle = half_fan * (2.0 * i / (count - 1) - 1);
    const Eigen::Vector3d ray = stage.tip_turn() * Eigen::Vector3d(0, std::sin(angle), std::cos(angle));
    int hit = -1;
    const mjtNum distance =
        mj_ray(&stage.model(), &stage.data(), origin.data(), ray.data(), groups.data(), 1, -1, &hit);
    const double away = 1e3 * distance * std::cos(angle);
    if (hit < 0 || away < nearest_valid || away > farthest_valid) continue;
    laser.points.push_back({1e3 * distance * std::sin(angle), away, origin + distance * ray});
  }
  return laser;
}

std::vector<Mark> marks_of(const Laser& laser, const Stage& stage) {
  constexpr std::size_t beams = 16;      // points from one drawn beam to the next
  constexpr double one_surface = 0.012;  // m from point to point
  std::vector<Mark> marks;
  for (std::size_t i = 0; i < laser.points.size(); ++i) {
    const Eigen::Vector3d& place = laser.points[i].place;
    if (i % beams == 0 || i + 1 == laser.points.size()) marks.push_back({stage.tip(), place, 0.0004, beam});
    if (i > 0 && (place - laser.points[i - 1].place).norm() < one_surface)
      marks.push_back({laser.points[i - 1].place, place, 0.0012, line});
  }
  return marks;
}

}  // namespace pal::sim
