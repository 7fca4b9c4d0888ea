#include <catch2/catch.hpp>

#include "sim/controller/planner.hpp"
#include "sim/controller/servo.hpp"
#include "sim/controller/trajectory.hpp"
#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace std::chrono_literals;

namespace {

Joints ready() {
  Joints q;
  q << 0.1, 0.8, -2.6, 0.2, -0.6, 0.3;
  return q;
}

constexpr auto tool_frame = CorrectionFrame::tool;

}  // namespace

TEST_CASE("a correction is moved evenly over its period, after those before it") {
  Trajectory trajectory(ready(), 28ms);
  CHECK_FALSE(trajectory.add({0, 0, 1, 0, 0, 0}, tool_frame, 10ms));
  CHECK_FALSE(trajectory.add({0, 0, 1, 0, 0, 0}, tool_frame, 38ms));
  const Pose start = tool_pose(ready());
  const auto height = [&](pal::runtime::Time when) {
    return (start.inverse() * tool_pose(trajectory.at(when).position)).translation().z() * 1e3;
  };
  CHECK(height(0ms) == Approx(0).margin(1e-9));
  CHECK(height(10ms) == Approx(0).margin(1e-9));
  CHECK(height(24ms) == Approx(0.5).margin(1e-3));  // joints move evenly, the tool nearly so
  CHECK(height(38ms) == Approx(1).margin(1e-9));
  CHECK_FALSE(trajectory.idle(65ms));
  CHECK(height(66ms) == Approx(2).margin(1e-9));
  CHECK(trajectory.idle(66ms));
  CHECK(trajectory.at(70ms).speed.norm() == 0);
}

TEST_CASE("stopping drops what was not moved yet, and later corrections start from there") {
  Trajectory trajectory(ready(), 28ms);
  REQUIRE_FALSE(trajectory.add({0, 0, 1, 0, 0, 0}, tool_frame, 0ms));
  trajectory.stop(14ms);
  const Joints there = trajectory.at(14ms).position;
  CHECK((trajectory.at(40ms).position - there).norm() == 0);
  CHECK((trajectory.goal().translation() - tool_pose(there).translation()).norm() < 1e-12);
  REQUIRE_FALSE(trajectory.add({0, 0, -0.5, 0, 0, 0}, tool_frame, 56ms));
  CHECK((tool_pose(trajectory.at(84ms).position).translation() - tool_pose(ready()).translation()).norm() <
        1e-5);
}

TEST_CASE("motions that the arm cannot make are refused, with the reason") {
  Trajectory trajectory(ready(), 28ms);
  CHECK(trajectory.add({0, 0, 15, 0, 0, 0}, tool_frame, 0ms).value() ==
        "the tool would move at 0.536 m/s, its limit is 0.5 m/s");
  CHECK(trajectory.add({0, 0, 0, 0, 0, 12}, tool_frame, 0ms).value() ==
        "joint 6 would turn at 7.48 rad/s, its limit is 5.74 rad/s");
  // Straight up until the arm is stretched.
  std::optional<std::string> refused;
  pal::runtime::Time begin{};
  for (int i = 0; i < 400 && !refused; ++i, begin += 28ms) {
    refused = trajectory.add({0, 0, 4, 0, 0, 0}, CorrectionFrame::world, begin);
    trajectory.at(begin + 28ms);
  }
  REQUIRE(refused);
  CAPTURE(*refused);
  CHECK((refused->find("reach") != std::string::npos || refused->find("would turn at") != std::string::npos ||
         refused->find("range of") != std::string::npos));
}

TEST_CASE("a joint that leaves its range is said to leave it, not to be too fast") {
  Joints q = ready();
  q[5] = radians(265.5);
  // A full turn back, joint 6 would be within its range again.
  Trajectory trajectory(q, 28ms);
  CHECK(trajectory.add({0, 0, 0, 0, 0, 1}, tool_frame, 0ms).value() ==
        "joint 6 would leave its range of -266 to 266 degrees");
  const Pose turned = tool_pose(q) * Eigen::AngleAxisd(radians(5), Eigen::Vector3d::UnitZ());
  const Plan plan = plan_straight_motion(q, turned, pad_tool(), {});
  REQUIRE(std::holds_alternative<Refusal>(plan));
  CHECK(std::get<Refusal>(plan).cause == Refusal::Cause::joint_range);
  CHECK(std::get<Refusal>(plan).joint == 5);
}

TEST_CASE("a speed just above its limit is told with as many figures as it needs") {
  CHECK(beyond_limit(2.4003, 2.4, "rad/s") == "2.4003 rad/s, its limit is 2.4 rad/s");
  CHECK(beyond_limit(8.666, 5.34, "rad/s") == "8.67 rad/s, its limit is 5.34 rad/s");
}

TEST_CASE("the frames of corrections") {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(radians(180), Eigen::Vector3d::UnitX()).toRotationMatrix();
  const Pose opened = pose;

  // Down, in the tool's frame and in the world's.
  CHECK(corrected(pose, {0, 0, 5, 0, 0, 0}, CorrectionFrame::tool, opened).translation().z() ==
        Approx(-0.005));
  CHECK(corrected(pose, {0, 0, 5, 0, 0, 0}, CorrectionFrame::world, opened).translation().z() ==
        Approx(0.005));

  // Once the tool has turned, its own frame and that of the beginning differ.
  const Pose turned = corrected(pose, {0, 0, 0, 0, 0, 90}, CorrectionFrame::tool, opened);
  const Eigen::Vector3d own =
      corrected(turned, {1, 0, 0, 0, 0, 0}, CorrectionFrame::tool, opened).translation();
  const Eigen::Vector3d old =
      corrected(turned, {1, 0, 0, 0, 0, 0}, CorrectionFrame::tool_at_open, opened).translation();
  CHECK((own - Eigen::Vector3d(0, -1e-3, 0)).norm() < 1e-12);
  CHECK((old - Eigen::Vector3d(1e-3, 0, 0)).norm() < 1e-12);

  // Ten thousand small turns leave a rotation a rotation.
  Pose many = Pose::Identity();
  for (int i = 0; i < 10000; ++i)
    many = corrected(many, {0, 0, 0, 0.1, 0.07, 0.05}, CorrectionFrame::tool, opened);
  CHECK((many.linear().transpose() * many.linear() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
}

TEST_CASE("servos give no more torque than the drives have") {
  JointServos servos;
  SetPoint far;
  far.position = Joints::Constant(3.0);
  const Joints torque = servos.torques(far, Joints::Zero(), Joints::Zero(), Joints::Zero());
  for (std::size_t i = 0; i < joint_count; ++i)
    CHECK(torque[static_cast<Eigen::Index>(i)] == Approx(puma_limits[i].torque));
  // Saturated, the integral does not wind up: back at the set-point nothing is left of it.
  const Joints after = servos.torques(far, far.position, Joints::Zero(), Joints::Zero());
  CHECK(after.norm() == 0);
}
