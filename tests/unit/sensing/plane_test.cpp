// How a surface lies before the tool.
#include "skills_pal/sensing/plane.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "skills_pal/sensing/motion.hpp"
#include "tests/unit/sensing/shapes.hpp"

namespace pal::skills::sensing {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double one_degree = std::numbers::pi / 180;

/// The plane's normal where turning about x, then about y makes the tool square to it.
Vector3d normal_at(double turn_x, double turn_y) {
  return AngleAxisd(turn_y * one_degree, Vector3d::UnitY()) *
         AngleAxisd(turn_x * one_degree, Vector3d::UnitX()) * Vector3d::UnitZ();
}

/// Align's motion: along the tool's x axis by `travel` and back, a profile each 78 ms, seen from where it
/// began.
std::vector<Vector3d> sweep(const Vector3d& normal, double distance, double travel, double speed,
                            std::mt19937& random, double jitter = 0) {
  std::normal_distribution<double> error(0, jitter);
  ToolMotion motion;
  const double half = 28 * std::round(travel / speed * 1000 / 28);  // ms; a corner only at ALTER's ticks
  const auto at = [&](double t) {
    const double x = speed * (t < half ? t : 2 * half - t) / 1000;
    return Isometry3d(Eigen::Translation3d(x, 0, 0));
  };
  for (double t = 0; t <= 2 * half; t += 28) motion.add(t, at(t));
  std::vector<Vector3d> points;
  std::vector<Vector3d> more(most_points);
  for (double taken = 0; taken + scan_time <= 2 * half; taken += 78) {
    Isometry3d pose = at(taken + scan_time / 2);
    pose.translation().z() += error(random);
    const test::Scan seen = test::scan(test::plane(normal, distance * normal.z(), pose), random);
    const std::size_t count = compensate(seen.profile(), taken, motion, 0, more);
    points.insert(points.end(), more.begin(), more.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return points;
}

TEST_CASE("plane: both leans and the distance, from one sweep along x", "[plane]") {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> lean(-20, 20), distance(150, 450);
  double worst_turn = 0, worst_distance = 0;
  for (int i = 0; i < 40; ++i) {
    const double turn_x = lean(random), turn_y = lean(random), z = distance(random);
    // 20 mm there and back at 1.5 mm each 28 ms: 0.75 s, nine profiles; the arm is 0.05 mm off here and
    // there.
    const auto points = sweep(normal_at(turn_x, turn_y), z, 30, 53.6, random, 0.05);
    const auto plane = find_plane(points);
    REQUIRE(plane);
    worst_turn = std::max({worst_turn, std::abs(plane->turn_x - turn_x), std::abs(plane->turn_y - turn_y)});
    worst_distance = std::max(worst_distance, std::abs(plane->standoff - z));
  }
  INFO("plane from 14 profiles: at most " << worst_turn << " deg and " << worst_distance << " mm off");
  CHECK(worst_turn < 0.5);  // Align's usual tolerance
  CHECK(worst_distance < 0.3);
}

TEST_CASE("plane: turning by what it says makes the tool square", "[plane]") {
  std::mt19937 random(2);
  const Vector3d normal = normal_at(13, -17);
  const auto plane = find_plane(sweep(normal, 250, 30, 53.6, random));
  REQUIRE(plane);
  CHECK((normal_at(plane->turn_x, plane->turn_y) - normal).norm() < 0.005);
}

TEST_CASE("plane: other things in view fall off", "[plane]") {
  std::mt19937 random(9);
  auto points = sweep(normal_at(5, -5), 250, 30, 53.6, random);
  for (std::size_t i = 0; i < points.size(); i += 7) points[i].z() -= 30 + 5 * static_cast<double>(i % 3);
  const auto plane = find_plane(points);
  REQUIRE(plane);
  CHECK(plane->turn_x == Approx(5).margin(0.3));
  CHECK(plane->turn_y == Approx(-5).margin(0.3));
  CHECK(plane->points < points.size());
}

TEST_CASE("plane: says that there is none", "[plane]") {
  std::mt19937 random(9);
  SECTION("one profile of a tool that stands still is a line") {
    std::vector<Vector3d> points(most_points);
    compensate(test::scan(test::outline({{-300, 200}, {300, 200}}), random).profile(), 0, {}, 0, points);
    CHECK_FALSE(find_plane(points));
  }
  SECTION("a roof") {
    std::vector<Vector3d> points;
    for (int x = -20; x <= 20; ++x) {
      for (int y = -50; y <= 50; ++y) points.emplace_back(x, y, 200 + 0.4 * std::abs(y));
    }
    CHECK_FALSE(find_plane(points));
  }
  SECTION("nothing in range") {
    CHECK_FALSE(find_plane({}));
  }
}

}  // namespace
}  // namespace pal::skills::sensing
