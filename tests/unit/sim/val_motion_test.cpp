#include <catch2/catch.hpp>
#include <cmath>

#include "sim/controller/motion_controller.hpp"
#include "sim/random.hpp"
#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;
using pal::runtime::Time;

namespace {

Joints ready() {
  Joints q;
  q << 0.1, 0.8, -2.6, 0.2, -0.6, 0.3;
  return q;
}

Pose shifted(const Pose& pose, double x, double y, double z) {
  return Eigen::Translation3d(x, y, z) * pose;
}

double seconds(Time time) {
  return std::chrono::duration<double>(time).count();
}

// How far `point` is from the line through `from` and `to`.
double off_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& point) {
  return (point - from).cross((to - from).normalized()).norm();
}

}  // namespace

TEST_CASE("speed law: no step in way, speed or acceleration, and none above its limit") {
  for (const auto& [length, top, gain] : {std::array{0.5, 0.25, 2.0}, {0.02, 0.25, 2.0}, {3.0, 1.5, 4.0}}) {
    const SpeedLaw law(length, top, gain);
    constexpr double step = 1e-4;
    SpeedLaw::State before = law.at(0);
    CHECK(before.way == 0);
    for (double t = step; t < law.duration() + step; t += step) {
      const SpeedLaw::State now = law.at(t);
      REQUIRE(std::abs(now.way - before.way - step * (now.speed + before.speed) / 2) < 1e-7);
      REQUIRE(std::abs(now.speed - before.speed - step * (now.acceleration + before.acceleration) / 2) <
              1e-6);
      REQUIRE(now.speed <= top + 1e-12);
      REQUIRE(std::abs(now.acceleration) <= gain + 1e-9);
      before = now;
    }
    CHECK(before.way == length);
    CHECK(before.speed == 0);
  }
  // 0.125 m gather and lose 0.25 m/s at 2 m/s^2; what is shorter is made slower.
  CHECK(SpeedLaw(0.5, 0.25, 2).duration() == Approx(2.25));
  CHECK(SpeedLaw(0.02, 0.25, 2).top_speed() == Approx(std::sqrt(0.02)));
  CHECK(SpeedLaw(0, 1, 1).duration() == 0);
}

TEST_CASE("inverse then forward over 10,000 poses, any tool") {
  constexpr std::uint64_t seed = 20260722;
  INFO("seed " << seed);
  Random random(seed, 0);
  const Pose tool = Eigen::Translation3d(0.049, 0.01, 0.397) *
                    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    Joints q;
    for (std::size_t j = 0; j < joint_count; ++j)
      q[static_cast<Eigen::Index>(j)] =
          puma_limits[j].lower + (puma_limits[j].upper - puma_limits[j].lower) * random.unit();
    const Pose pose = tool_pose(q, tool);
    const InverseSolution solution = inverse_tool(pose, tool, configuration_of(q), q);
    REQUIRE(solution.problem == InverseProblem::none);
    worst = std::max(worst, (tool_pose(solution.q, tool).matrix() - pose.matrix()).cwiseAbs().maxCoeff());
  }
  CHECK(worst < 1e-9);
}

TEST_CASE("joint-interpolated: all joints begin and end together, within their limits") {
  MotionController motion(ready(), 28ms);
  Joints goal = ready();
  goal += (Joints() << 1.0, 0.3, 0.2, -0.5, 0.4, 2.0).finished();
  REQUIRE_FALSE(motion.move_joints(goal, {}, 10ms));
  const Time end = motion.planned_end(10ms);
  CHECK_FALSE(motion.idle(end - 1ms));
  CHECK(motion.idle(end));
  Joints last_speed = Joints::Zero();
  for (Time t = 10ms; t < end; t += 1ms) {
    const SetPoint point = motion.at(t);
    const Joints part = (point.position - ready()).cwiseQuotient(goal - ready());
    REQUIRE((part.array() - part[0]).abs().maxCoeff() < 1e-12);
    REQUIRE_FALSE(too_fast(point.speed));
    for (std::size_t i = 0; i < joint_count; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      REQUIRE(std::abs(point.speed[row] - last_speed[row]) <= joint_accelerations[i] * 1.001e-3 + 1e-12);
    }
    last_speed = point.speed;
  }
  CHECK((motion.at(end).position - goal).norm() < 1e-12);
  CHECK(motion.at(end).speed.norm() == 0);
}

TEST_CASE("straight: the tip stays on the line, and the tool turns evenly") {
  MotionController motion(ready(), 28ms);
  const Pose start = tool_pose(ready());
  Pose goal = shifted(start, 0.02, 0.15, 0.05);
  goal.linear() = start.linear() * Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  REQUIRE_FALSE(motion.move_straight(goal, {.part = 1, .straight = 0.1}, 0ms));
  const Time first = motion.planned_end(0ms);
  REQUIRE_FALSE(motion.move_straight(start, {.part = 0.2, .straight = {}}, 5ms));
  const Time second = motion.planned_end(5ms);
  CHECK(second > first + 1s);
  double top = 0;
  Eigen::Vector3d before = start.translation();
  for (Time t{}; t <= second; t += 1ms) {
    const SetPoint point = motion.at(t);
    const Pose pose = tool_pose(point.position);
    REQUIRE(off_line(start.translation(), goal.translation(), pose.translation()) < 2e-8);
    const double along =
        (pose.translation() - start.translation()).norm() / (goal.translation() - start.translation()).norm();
    const Eigen::AngleAxisd turned(start.linear().transpose() * pose.linear());
    REQUIRE(std::abs(turned.angle() - along * 0.4) < 1e-6);
    top = std::max(top, (pose.translation() - before).norm() / 1e-3);
    before = pose.translation();
  }
  CHECK(top == Approx(0.1).epsilon(1e-3));  // 0.2 of 0.5 m/s is the same
  CHECK((before - start.translation()).norm() < 1e-9);
}

TEST_CASE("speeds and accelerations of set-points are the derivatives of their positions") {
  MotionController motion(ready(), 28ms);
  REQUIRE_FALSE(motion.move_straight(shifted(tool_pose(ready()), 0.0, 0.2, -0.05), {}, 0ms));
  const auto stop_at = GENERATE(0ms, 300ms);
  SetPoint before = motion.at(0ms);
  for (Time t = 100us; t < motion.planned_end(0ms); t += 100us) {
    if (stop_at > 0ms && t == stop_at) motion.stop(t);
    const SetPoint now = motion.at(t);
    REQUIRE((now.position - before.position - 0.5e-4 * (now.speed + before.speed)).norm() < 2e-8);
    // Between two knots a cubic's second derivative has a small step.
    REQUIRE((now.speed - before.speed - 0.5e-4 * (now.acceleration + before.acceleration)).norm() < 2e-5);
    before = now;
  }
  CHECK(before.speed.norm() < 1e-4);
}

TEST_CASE("on a stop the arm slows down on its line and drops the rest") {
  MotionController motion(ready(), 28ms);
  const Pose start = tool_pose(ready()), goal = shifted(start, 0, 0.2, 0);
  REQUIRE_FALSE(motion.move_straight(goal, {}, 0ms));
  REQUIRE_FALSE(motion.move_straight(start, {}, 0ms));
  motion.at(250ms);
  motion.stop(250ms);
  const Time end = motion.planned_end(250ms);
  CHECK(seconds(end) < 0.7);
  Eigen::Vector3d before = tool_pose(motion.at(250ms).position).translation();
  double speed = tool_pose(motion.at(251ms).position).translation().y() - before.y();
  for (Time t = 251ms; t <= end; t += 1ms) {
    const Eigen::Vector3d now = tool_pose(motion.at(t).position).translation();
    REQUIRE(off_line(start.translation(), goal.translation(), now) < 2e-8);
    const double next = (now - before).norm();
    REQUIRE(std::abs(speed - next) < 4e-6);  // 2 m/s^2 a millisecond, and some of the motion's own
    speed = next;
    before = now;
  }
  CHECK(motion.idle(end));
  CHECK(motion.at(end + 1ms).speed.norm() == 0);
  CHECK((before - start.translation()).norm() < 0.19);
  // From there on it moves as before.
  REQUIRE_FALSE(motion.move_straight(start, {}, end));
  CHECK((tool_pose(motion.at(motion.planned_end(end)).position).matrix() - start.matrix()).norm() < 1e-8);
}

TEST_CASE("impossible motions are refused before they begin: reach, ranges, singularities") {
  MotionController motion(ready(), 28ms);
  const Pose start = tool_pose(ready());
  const auto straight = [&](double x, double y, double z) {
    return motion.move_straight(shifted(start, x, y, z), {}, 0ms).value();
  };
  CHECK(straight(1.5, 0, 0).cause == Refusal::Cause::too_far);
  CHECK(motion.move_to(shifted(start, 0, 0, 3), configuration_of(ready()), {}, 0ms)->cause ==
        Refusal::Cause::too_far);

  Joints out = ready();
  out[2] = radians(60);
  const Refusal range = motion.move_joints(out, {}, 0ms).value();
  CHECK(range.cause == Refusal::Cause::joint_range);
  CHECK(range.joint == 2);
  CHECK(range.text == "joint 3 would leave its range of -225 to 45 degrees");

  CHECK(motion.move_straight(start, {.part = 1, .straight = 0.6}, 0ms)->text ==
        "the tool would move at 0.6 m/s, its limit is 0.5 m/s");

  // Past the wrist's singularity: a line along which q5 goes through 0 beside it.
  Joints bent = ready();
  bent[3] = 1.2;
  bent[4] = -0.05;
  MotionController wrist(bent, 28ms);
  const Pose tool_up = tool_pose(bent);
  Pose over = tool_up;
  over.linear() = tool_up.linear() * Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitX()).toRotationMatrix();
  bool refused = false;
  for (const double angle : {-0.6, 0.6}) {
    over.linear() = tool_up.linear() * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
    const auto refusal = wrist.move_straight(over, {}, 0ms);
    if (!refusal) {
      wrist.hold(bent);
      continue;
    }
    refused = true;
    CHECK(refusal->cause == Refusal::Cause::joint_speed);
    CHECK((refusal->joint == 3 || refusal->joint == 5));
  }
  CHECK(refused);
  CHECK(wrist.idle(0ms));
}

TEST_CASE("planned motions and corrections keep out of each other's way") {
  MotionController motion(ready(), 28ms);
  const Pose start = tool_pose(ready());
  REQUIRE_FALSE(motion.move_straight(shifted(start, 0, 0.01, 0), {}, 0ms));
  CHECK(motion.correct({0, 0, 1, 0, 0, 0}, CorrectionFrame::tool, 28ms).value() ==
        "the arm is still making a motion that VAL gave it");
  const Time end = motion.planned_end(0ms);
  motion.open_corrections(end);
  REQUIRE_FALSE(motion.correct({0, -10, 0, 0, 0, 0}, CorrectionFrame::world, end));
  CHECK(motion.move_straight(start, {}, end + 1ms)->text == "corrections are still being moved");
  const Pose there = tool_pose(motion.at(end + 28ms).position);
  CHECK((there.matrix() - start.matrix()).norm() < 1e-8);
  CHECK_FALSE(motion.move_straight(shifted(start, 0, 0.01, 0), {}, end + 28ms));
}

TEST_CASE("corrections that are not cumulative count from where ALTER was opened") {
  MotionController motion(ready(), 28ms);
  const Pose start = tool_pose(ready());
  motion.open_corrections(0ms);
  for (int i = 0; i < 3; ++i)
    REQUIRE_FALSE(motion.correct({0, 2, 0, 0, 0, 0}, CorrectionFrame::world, i * 28ms, false));
  const Eigen::Vector3d there = tool_pose(motion.at(84ms).position).translation();
  CHECK((there - start.translation() - Eigen::Vector3d(0, 0.002, 0)).norm() < 1e-9);
}

TEST_CASE("another tool is the point that moves, and is changed only at rest") {
  MotionController motion(ready(), 28ms);
  const Pose tool(Eigen::Translation3d(0.049, 0, 0.397));
  REQUIRE(motion.set_tool(tool, 0ms));
  const Pose start = tool_pose(ready(), tool);
  Pose goal = start;
  goal.linear() = start.linear() * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()).toRotationMatrix();
  REQUIRE_FALSE(motion.move_straight(goal, {}, 0ms));
  CHECK_FALSE(motion.set_tool(pad_tool(), 1ms));
  const Time end = motion.planned_end(0ms);
  for (Time t{}; t <= end; t += 5ms)
    REQUIRE((tool_pose(motion.at(t).position, tool).translation() - start.translation()).norm() < 1e-7);
  motion.open_corrections(end);
  REQUIRE_FALSE(motion.correct({0, 0, 0, 1, 0, 0}, CorrectionFrame::tool, end));
  CHECK((tool_pose(motion.at(end + 28ms).position, tool).translation() - start.translation()).norm() < 1e-8);
}

TEST_CASE(
    "the arm follows a straight line within 0.15 mm at 0.25 m/s and 2 m/s^2, and is there 150 ms later") {
  Workcell workcell(scene("nothing"));
  const Pose start = workcell.set_point();
  const Pose goal = shifted(start, 0, 0.3, 0.1);
  REQUIRE_FALSE(workcell.motion().move_straight(goal, {.part = 1, .straight = 0.25}, workcell.now()));
  double off = 0, top = 0;
  const Time end = workcell.motion().planned_end(workcell.now());
  Eigen::Vector3d before = start.translation();
  while (workcell.now() < end) {
    workcell.advance_to(workcell.now() + 1ms);
    const Sample& sample = workcell.log().back();
    off = std::max(off, off_line(start.translation(), goal.translation(), sample.tool));
    top = std::max(top, (sample.set_point - before).norm() / 1e-3);
    before = sample.set_point;
  }
  CHECK(off < 0.15e-3);
  CHECK(top == Approx(0.25).epsilon(1e-3));
  workcell.advance_to(end + 150ms);
  CHECK((workcell.tool().translation() - goal.translation()).norm() < 0.05e-3);
}
