// The figures that the servos are held to: straight lines, rest, repeatability.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/arm/joint_sensing.hpp"
#include "sim/controller/servo.hpp"
#include "sim/model/mujoco_physics.hpp"
#include "sim/random.hpp"
#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;

namespace {

// The arm on its servos, told where its tool shall be in each millisecond.
class Rig {
 public:
  explicit Rig(const MachineOptions& machine) : physics_(scene("nothing")), sensing_(machine) {
    const Start& start = physics_.loaded().start;
    start_ = start.tool;
    last_ = inverse_tool(start_, start.configuration, Joints::Zero()).q;
    physics_.place(last_);
    follow(Eigen::Vector3d::Zero(), 400);
  }

  // Holds the tool at `offset` (m) from its start.
  void follow(const Eigen::Vector3d& offset, int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) step(offset);
  }

  void step(const Eigen::Vector3d& offset) {
    Pose wanted = start_;
    wanted.translation() += offset;
    SetPoint point;
    point.position = inverse_tool(wanted, physics_.loaded().start.configuration, last_).q;
    point.speed = (point.position - last_) / 1e-3;
    point.acceleration = (point.speed - last_speed_) / 1e-3;
    last_ = point.position;
    last_speed_ = point.speed;
    point.position = sensing_.nearest(point.position);
    const Joints torques = servos_.torques(point, sensing_.read(physics_.joints()), physics_.joint_speeds(),
                                           physics_.load(point.acceleration));
    sensing_.advance(torques);
    physics_.step(torques, {});
  }

  // Where the tool is from its start, mm.
  Eigen::Vector3d offset() const {
    return (physics_.site_pose(physics_.index().tip).translation() - start_.translation()) * 1e3;
  }

 private:
  Physics physics_;
  JointSensing sensing_;
  JointServos servos_;
  Pose start_;
  Joints last_ = Joints::Zero();
  Joints last_speed_ = Joints::Zero();
};

// Way along a line of `length` (m) after `time` (s), at 0.25 m/s and 2 m/s^2.
double way(double time, double length) {
  constexpr double speed = 0.25, acceleration = 2;
  const double ramp = speed / acceleration, total = length / speed + ramp;
  if (time < ramp) return 0.5 * acceleration * time * time;
  if (time < total - ramp) return speed * (time - 0.5 * ramp);
  if (time < total) return length - 0.5 * acceleration * (total - time) * (total - time);
  return length;
}

struct LineFigures {
  double beside = 0;  // mm from the line, at most
  double rest = 0;    // mm from its end, at most from 150 ms after the end of motion
};

LineFigures along(Rig& rig, const Eigen::Vector3d& line) {
  LineFigures figures;
  const double length = line.norm();
  const Eigen::Vector3d direction = line / length;
  const int moving = static_cast<int>(std::ceil(1e3 * (length / 0.25 + 0.125)));
  for (int i = 1; i <= moving + 600; ++i) {
    rig.step(way(i * 1e-3, length) * direction);
    const Eigen::Vector3d beside = rig.offset() - rig.offset().dot(direction) * direction;
    figures.beside = std::max(figures.beside, beside.norm());
    if (i > moving + 150) figures.rest = std::max(figures.rest, (rig.offset() - line * 1e3).norm());
  }
  return figures;
}

const std::vector<Eigen::Vector3d> lines{{0, 0.3, 0}, {0.2, 0, 0}, {0.1, -0.15, -0.2}, {0, 0, -0.25}};

}  // namespace

TEST_CASE(
    "servos: straight lines within 0.15 mm at 0.25 m/s and 2 m/s^2, at rest within 0.05 mm after 150 ms") {
  for (const Eigen::Vector3d& line : lines) {
    Rig rig(MachineOptions::exact());
    const LineFigures figures = along(rig, line);
    CAPTURE(line.transpose(), figures.beside, figures.rest);
    CHECK(figures.beside < 0.15);
    CHECK(figures.rest < 0.05);
  }
}

TEST_CASE("servos: with counts and play within 0.15 mm, on the line and at rest") {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    Rig rig({.seed = seed});
    const LineFigures figures = along(rig, lines[seed - 1]);
    CAPTURE(seed, figures.beside, figures.rest);
    CHECK(figures.beside < 0.15);
    CHECK(figures.rest < 0.15);
  }
}

TEST_CASE("servos: a pose is repeated within 0.1 mm from all sides, and not exactly") {
  Rig rig(MachineOptions{});
  std::vector<Eigen::Vector3d> ends;
  Random random(7, 0);
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector3d away(0.06 * random.unit() - 0.03, 0.06 * random.unit() - 0.03,
                               0.04 * random.unit());
    for (int t = 1; t <= 300; ++t) rig.step(away * 0.5 * (1 - std::cos(radians(180.0 * t / 300))));
    for (int t = 1; t <= 300; ++t) rig.step(away * 0.5 * (1 + std::cos(radians(180.0 * t / 300))));
    rig.follow(Eigen::Vector3d::Zero(), 200);
    ends.push_back(rig.offset());
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& end : ends) mean += end / static_cast<double>(ends.size());
  double spread = 0;
  for (const Eigen::Vector3d& end : ends) spread = std::max(spread, (end - mean).norm());
  CAPTURE(spread, mean.transpose());
  CHECK(spread < 0.1);
  CHECK(spread > 0.005);
}
