#include "sim/arm/kinematics.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/model/mujoco_physics.hpp"
#include "sim/random.hpp"
#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using pal::sim::test::scene;

namespace {

// Uniformly within the joints' limits.
Joints random_joints(Random& random) {
  Joints q;
  for (std::size_t i = 0; i < joint_count; ++i)
    q[static_cast<Eigen::Index>(i)] =
        puma_limits[i].lower + (puma_limits[i].upper - puma_limits[i].lower) * random.unit();
  return q;
}

double difference(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

constexpr std::uint64_t seed = 20240601;

}  // namespace

TEST_CASE("the model's kinematics are the Denavit-Hartenberg formula's") {
  INFO("seed " << seed);
  Random random(seed, 0);
  Physics physics(scene("touch"));
  for (int i = 0; i < 500; ++i) {
    const Joints q = random_joints(random);
    physics.place(q);
    CHECK(difference(physics.site_pose(physics.index().wrist), wrist_pose(q)) < 1e-9);
    CHECK(difference(physics.site_pose(physics.index().tip), tool_pose(q)) < 1e-9);
  }
}

TEST_CASE("well-known poses of the PUMA 560") {
  // Corke's toolbox, p560 with these link parameters: fkine of the zero, ready and stretched poses.
  const auto at = [](std::initializer_list<double> degrees_) -> Eigen::Vector3d {
    Joints q;
    Eigen::Index row = 0;
    for (const double angle : degrees_) q[row++] = radians(angle);
    return wrist_pose(q).translation();
  };
  CHECK((at({0, 0, 0, 0, 0, 0}) - Eigen::Vector3d(0.4521, -0.1500, 0.4318)).norm() < 1e-4);
  CHECK((at({0, 90, -90, 0, 0, 0}) - Eigen::Vector3d(0.0203, -0.1500, 0.8636)).norm() < 1e-4);
  CHECK((at({0, 0, -90, 0, 0, 0}) - Eigen::Vector3d(0.8636, -0.1500, -0.0203)).norm() < 1e-4);
}

TEST_CASE("all eight inverse solutions bring the wrist back, each in the configuration asked for") {
  INFO("seed " << seed);
  Random random(seed, 1);
  int reached = 0;
  for (int i = 0; i < 2000; ++i) {
    const Joints q = random_joints(random);
    if (std::abs(std::sin(q[4])) < 1e-3) continue;
    const Pose wrist = wrist_pose(q);
    CAPTURE(q.transpose());
    for (int bits = 0; bits < 8; ++bits) {
      const Configuration wanted{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
      const InverseSolution solution = inverse_wrist(wrist, wanted, Joints::Zero());
      REQUIRE((solution.problem == InverseProblem::none || solution.problem == InverseProblem::over_limit));
      CHECK(difference(wrist_pose(solution.q), wrist) < 1e-9);
      CHECK(configuration_of(solution.q) == wanted);
      if (solution.problem == InverseProblem::over_limit) continue;
      ++reached;
      for (std::size_t j = 0; j < joint_count; ++j) {
        CHECK(solution.q[static_cast<Eigen::Index>(j)] >= puma_limits[j].lower - 1e-9);
        CHECK(solution.q[static_cast<Eigen::Index>(j)] <= puma_limits[j].upper + 1e-9);
      }
    }
    // The configuration that the pose was made with is among them, with these very angles.
    const InverseSolution same = inverse_wrist(wrist, configuration_of(q), q);
    REQUIRE(same.problem == InverseProblem::none);
    CHECK((same.q - q).cwiseAbs().maxCoeff() < 1e-7);
  }
  CHECK(reached > 2000);
}

TEST_CASE("poses that the arm cannot take say why") {
  const Configuration any;
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Vector3d(1.2, 0, 0);
  CHECK(inverse_wrist(pose, any, Joints::Zero()).problem == InverseProblem::too_far);
  pose.translation() = Eigen::Vector3d(0.05, 0, 0.4);
  CHECK(inverse_wrist(pose, any, Joints::Zero()).problem == InverseProblem::too_near);

  // Joint 1 at 170 degrees is past its limit of 160.
  Joints q = Joints::Zero();
  q[0] = radians(170);
  q[4] = radians(30);
  const InverseSolution solution = inverse_wrist(wrist_pose(q), configuration_of(q), q);
  CHECK(solution.problem == InverseProblem::over_limit);
  CHECK(solution.joint == 0);
}

TEST_CASE("if joints 4 and 6 are in line, joint 4 stays") {
  Joints q;
  q << 0.3, 0.4, -2.0, 0.7, 0.0, 0.5;
  const InverseSolution solution = inverse_wrist(wrist_pose(q), configuration_of(q), q);
  REQUIRE(solution.problem == InverseProblem::none);
  CHECK((solution.q - q).cwiseAbs().maxCoeff() < 1e-7);
}

TEST_CASE("configurations read as they are written") {
  for (int bits = 0; bits < 8; ++bits) {
    const Configuration configuration{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
    CHECK(parse_configuration(to_string(configuration)) == configuration);
  }
  CHECK(parse_configuration("flip lefty below") == Configuration{false, false, true});
  CHECK_FALSE(parse_configuration("lefty above"));
  CHECK_FALSE(parse_configuration("lefty righty above flip"));
  CHECK_FALSE(parse_configuration("left above flip"));
}
