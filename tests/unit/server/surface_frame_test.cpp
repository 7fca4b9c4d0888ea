// A tool that stands square on a surface, from three places on it.
#include "server/surface_frame.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace pal::server;

namespace {

ScenePose at(double x, double y, double z, const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity()) {
  return {{x, y, z}, {turn.x(), turn.y(), turn.z(), turn.w()}};
}

Eigen::Matrix3d axes_of(const ScenePose& pose) {
  return Eigen::Quaterniond(pose.turn.data()).toRotationMatrix();
}

const Eigen::Quaterniond down(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));

}  // namespace

TEST_CASE("a frame on a slope is square to it, and its x axis leads to the second place") {
  // The slope rises by 30 degrees along x; the tool comes from above, leaning.
  const double rise = std::tan(std::numbers::pi / 6);
  const Eigen::Quaterniond leaning =
      down * Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()));
  const bool other_side = GENERATE(false, true);
  const auto frame = surface_frame(at(0, 0, 0, leaning), at(0.1, 0, 0.1 * rise),
                                   at(0.02, other_side ? -0.1 : 0.1, 0.02 * rise));
  REQUIRE(frame);
  const Eigen::Matrix3d axes = axes_of(*frame);
  const Eigen::Vector3d into(std::sin(std::numbers::pi / 6), 0, -std::cos(std::numbers::pi / 6));
  CHECK((axes.col(2) - into).norm() < 1e-9);
  CHECK((axes.col(0) - Eigen::Vector3d(0.1, 0, 0.1 * rise).normalized()).norm() < 1e-9);
  CHECK(std::abs(axes.determinant() - 1) < 1e-9);
  CHECK(frame->position == std::array{0.0, 0.0, 0.0});
}

TEST_CASE("three places on a line, or two at one place, have no surface") {
  CHECK_FALSE(surface_frame(at(0, 0, 0, down), at(0.1, 0, 0), at(0.2, 0.01, 0)));
  CHECK_FALSE(surface_frame(at(0, 0, 0, down), at(0.001, 0, 0), at(0, 0.1, 0)));
  CHECK_FALSE(surface_frame(at(0, 0, 0, down), at(0.1, 0, 0), at(0, 0.004, 0)));
  CHECK(surface_frame(at(0, 0, 0, down), at(0.1, 0, 0), at(0.2, 0.05, 0)));
}
