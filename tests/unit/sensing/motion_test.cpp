// Profiles of a tool that moves.
#include "skills_pal/sensing/motion.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/unit/sensing/shapes.hpp"

namespace pal::skills::sensing {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

Isometry3d pose(double x, double y, double z, double about_x = 0) {
  Isometry3d result(Eigen::Translation3d(x, y, z));
  result.rotate(AngleAxisd(about_x, Vector3d::UnitX()));
  return result;
}

TEST_CASE("tool motion: in between straight and even, beyond its ends at rest", "[motion]") {
  ToolMotion motion;
  CHECK(motion.empty());
  motion.add(0, pose(0, 0, 0));
  motion.add(28, pose(2.8, 0, -1.4, 0.02));
  motion.add(28, pose(100, 0, 0));  // no time has passed: ignored
  CHECK(motion.at(7).translation().isApprox(Vector3d(0.7, 0, -0.35)));
  CHECK(AngleAxisd(motion.at(7).linear()).angle() == Approx(0.005));
  CHECK(motion.at(-5).isApprox(pose(0, 0, 0)));
  CHECK(motion.at(50).isApprox(pose(2.8, 0, -1.4, 0.02)));
}

TEST_CASE("tool motion: keeps the newest", "[motion]") {
  ToolMotion motion;
  for (int i = 0; i < 1000; ++i) motion.add(i, pose(i, 0, 0));
  CHECK(motion.at(999).translation().x() == 999);
  CHECK(motion.at(950.5).translation().x() == Approx(950.5));
  CHECK(motion.at(0).translation().x() == 936);
}

TEST_CASE("motion compensation: a plane stays where it is while the tool moves over it", "[motion]") {
  // 80 mm/s sideways, 50 mm/s towards the plane, turning 10 degrees a second, from 1000 ms on.
  const auto at = [](double instant) {
    const double s = (instant - 1000) / 1000;
    return pose(80 * s, 30 * s, 50 * s, 0.175 * s);
  };
  const Vector3d normal = Vector3d(0.1, -0.2, 1).normalized();
  const double distance = 200;
  test::Scan seen;
  std::mt19937 random(1);
  for (std::size_t i = 0; i < most_points; ++i) {
    const test::Scan now = test::scan(test::plane(normal, distance, at(1000 + point_time(i))), random, 0);
    seen.y[i] = now.y[i];
    seen.z[i] = now.z[i];
    seen.valid[i] = now.valid[i];
  }
  ToolMotion motion;
  for (int k = 0; k < 6; ++k) motion.add(980 + 28 * k, at(980 + 28 * k));

  std::vector<Vector3d> points(most_points);
  REQUIRE(compensate(seen.profile(), 1000, motion, 1076, points) == most_points);
  const Isometry3d tool = at(1076);
  double worst = 0, uncompensated = 0;
  for (std::size_t i = 0; i < most_points; ++i) {
    worst = std::max(worst, std::abs(normal.dot(tool * points[i]) - distance));
    uncompensated =
        std::max(uncompensated, std::abs(normal.dot(tool * Vector3d(0, seen.y[i], seen.z[i])) - distance));
  }
  INFO("a plane under a moving tool: " << worst << " mm off, " << uncompensated
                                       << " mm without compensation");
  CHECK(worst < 0.12);  // two steps of 0.1 mm, halved, and turning in straight pieces
  CHECK(uncompensated > 2);
}

TEST_CASE("motion compensation: without motion the points are where the profile has them", "[motion]") {
  std::mt19937 random(1);
  test::Scan seen = test::scan(test::outline({{-300, 200}, {300, 200}}), random, 0);
  seen.valid[3] = false;
  std::vector<Vector3d> points(most_points);
  REQUIRE(compensate(seen.profile(), 0, {}, 0, points) == most_points - 1);
  CHECK(points[0] == Vector3d(0, seen.y[0], seen.z[0]));
  CHECK(points[3] == Vector3d(0, seen.y[4], seen.z[4]));
}

}  // namespace
}  // namespace pal::skills::sensing
