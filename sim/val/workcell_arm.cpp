#include "sim/val/workcell_arm.hpp"

#include <algorithm>

namespace pal::sim::val {
namespace {

// A motion has ended when the tip is so near to where it was told to be, or when it has had so long for it.
constexpr double near_enough = 0.1e-3;  // m
constexpr runtime::Time long_enough = std::chrono::milliseconds(150);
constexpr runtime::Time between_looks = std::chrono::milliseconds(2);

}  // namespace

WorkcellArm::WorkcellArm(Workcell& workcell, const runtime::Timeline& timeline)
    : workcell_(workcell), timeline_(timeline) {}

Joints WorkcellArm::joints() const {
  return workcell_.joints();
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
  const Pose there = tool_pose(workcell_.joints(), motion.tool());
  return (wanted.translation() - there.translation()).norm() <= near_enough ||
         now() >= motion.still_since() + long_enough;
}

runtime::Time WorkcellArm::look_again() const {
  return std::max(workcell_.motion().planned_end(now()), now() + between_looks);
}

std::string WorkcellArm::fault() const {
  return {};
}

std::string WorkcellArm::clear_fault() {
  return {};
}

}  // namespace pal::sim::val
