#include "sim/val/workcell_arm.hpp"

#include <algorithm>
#include <cmath>

namespace pal::sim::val {
namespace {

// A motion has ended when the tip is this near to where it was told to be, or after this time.
constexpr double near_enough = 0.1e-3;  // m
constexpr runtime::Time long_enough = std::chrono::milliseconds(150);
constexpr runtime::Time between_looks = std::chrono::milliseconds(2);

// Fingers are at rest when they have moved by no more than `still` during `least`.
constexpr double still = 0.05;  // mm
constexpr runtime::Time least = std::chrono::milliseconds(80);

}  // namespace

WorkcellArm::WorkcellArm(Workcell& workcell, const runtime::drivers::Timeline& timeline)
    : workcell_(workcell), timeline_(timeline) {}

Joints WorkcellArm::joints() const {
  return workcell_.encoder_joints();
}

Joints WorkcellArm::goal() const {
  return workcell_.motion().goal(now());
}

Pose WorkcellArm::tool() const {
  return workcell_.motion().tool();
}

bool WorkcellArm::set_tool(const Pose& tool) {
  return workcell_.motion().set_tool(tool, now());
}

std::optional<Refusal> WorkcellArm::move_joints(const Joints& goal, const MotionSpeed& speed) {
  return workcell_.motion().move_joints(goal, speed, now());
}

std::optional<Refusal> WorkcellArm::move_to(const Pose& goal, Configuration configuration,
                                            const MotionSpeed& speed) {
  return workcell_.motion().move_to(goal, configuration, speed, now());
}

std::optional<Refusal> WorkcellArm::move_straight(const Pose& goal, const MotionSpeed& speed) {
  return workcell_.motion().move_straight(goal, speed, now());
}

void WorkcellArm::stop() {
  workcell_.motion().stop(now());
}

bool WorkcellArm::at_rest() const {
  MotionController& motion = workcell_.motion();
  if (!motion.idle(now())) return false;
  const Pose wanted = tool_pose(motion.goal(now()), motion.tool());
  const Pose there = tool_pose(workcell_.encoder_joints(), motion.tool());
  return (wanted.translation() - there.translation()).norm() <= near_enough ||
         now() >= motion.still_since() + long_enough;
}

runtime::Time WorkcellArm::look_again() const {
  return std::max(workcell_.motion().planned_end(now()), now() + between_looks);
}

std::string WorkcellArm::fault() const {
  return workcell_.fault() ? workcell_.fault()->text : std::string();
}

std::string WorkcellArm::clear_fault() {
  if (workcell_.fault()) workcell_.reset_fault();
  return {};
}

void WorkcellHand::open() {
  workcell_.gripper_open();
  commanded_ = timeline_.now();
}

void WorkcellHand::close() {
  workcell_.gripper_close();
  commanded_ = timeline_.now();
}

bool WorkcellHand::at_rest() const {
  const runtime::Time now = timeline_.now();
  const double width = workcell_.gripper_width();
  if (std::abs(width - width_) > still) {
    width_ = width;
    still_since_ = now;
  }
  return now >= commanded_ + least && now >= still_since_ + least;
}

}  // namespace pal::sim::val
