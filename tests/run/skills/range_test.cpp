// Standoff and align: each way in which they end.
#include <catch2/catch.hpp>

#include "tests/run/skills/support/physical_run.hpp"

using namespace pal;
using namespace pal::test;

namespace {

/// From the tip along the tool's axis to a plane through `point` (mm) with this normal.
double standoff(const sim::Sample& at, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d axis = at.tool_turn * Eigen::Vector3d::UnitZ();
  return normal.dot(point - at.tool * 1e3) / normal.dot(axis);
}

}  // namespace

TEST_CASE("standoff comes to the distance, from above and from below, completion 0") {
  const double distance = GENERATE(170.0, 260.0);
  const auto result =
      run({.skill = "standoff", .scene = "flat", .parameters = {{"distance", distance}, {"speed", 2}}});
  CAPTURE(result.outcome.reason);
  REQUIRE(result.outcome.code == 0);
  // The plate is 15 mm high and its underside is at -120 mm.
  const double reached = standoff(result.log.back(), {480, -200, -105}, Eigen::Vector3d::UnitZ());
  CHECK(reached == Approx(distance).margin(0.4));
}

TEST_CASE("standoff and align say that nothing is in range, completion 1, and stand still") {
  const std::string skill = GENERATE("standoff", "align");
  const auto result = run({.skill = skill, .scene = "nothing-in-view"});
  CAPTURE(result.outcome.reason);
  CHECK(result.outcome.code == 1);
  CHECK((result.log.back().tool - result.log.front().tool).norm() < 1e-4);
}

TEST_CASE("align stands square to a plate that leans about both axes, completion 0") {
  const auto result = run({.skill = "align", .scene = "tilted", .parameters = {{"tolerance", 0.1}}});
  CAPTURE(result.outcome.reason);
  REQUIRE(result.outcome.code == 0);
  const double degree = 3.14159265358979 / 180;
  const Eigen::Vector3d normal = Eigen::AngleAxisd(12 * degree, Eigen::Vector3d::UnitX()) *
                                 Eigen::AngleAxisd(5 * degree, Eigen::Vector3d::UnitY()) *
                                 Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d axis = result.log.back().tool_turn * Eigen::Vector3d::UnitZ();
  CHECK(std::acos(std::min(1.0, -axis.dot(normal))) / degree < 0.15);
}

TEST_CASE("align refuses what is not flat, completion 1") {
  const auto result = run({.skill = "align", .scene = "pyramid"});
  CAPTURE(result.outcome.reason);
  CHECK(result.outcome.code == 1);
}

TEST_CASE("a skill for the range finder ends with its error completion where there is none") {
  CHECK(run({.skill = "standoff", .scene = "touch"}).outcome.code == 2);
}

TEST_CASE("follow-edge goes the distance, completion 0") {
  const auto result =
      run({.skill = "follow-edge", .scene = "seam", .parameters = {{"distance", 3}, {"track", 0.6}}});
  CAPTURE(result.outcome.reason);
  CHECK(result.outcome.code == 0);
  CHECK((result.log.back().tool - result.log.front().tool).x() * 1e3 == Approx(30).margin(3));
}

TEST_CASE("follow-edge without an edge stands still, completion 1") {
  const auto result = run({.skill = "follow-edge", .scene = "flat"});
  CAPTURE(result.outcome.reason);
  CHECK(result.outcome.code == 1);
  CHECK((result.log.back().tool - result.log.front().tool).norm() < 1e-3);
}
