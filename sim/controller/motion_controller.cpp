#include "sim/controller/motion_controller.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pal::sim {
namespace {

constexpr double least_braking = 0.02;  // s
constexpr std::size_t queue_limit = 4;

double in_seconds(runtime::Time time) {
  return std::chrono::duration<double>(time).count();
}

runtime::Time time_of(double seconds) {
  return runtime::Time(static_cast<runtime::Time::rep>(std::ceil(seconds * 1e9)));
}

}  // namespace

MotionController::MotionController(const Joints& start, runtime::Time period, const Pose& tool)
    : tool_(tool), corrections_(start, period, tool) {}

runtime::Time MotionController::first_takes() const {
  return time_of(braking_ ? braking_->from + braking_->length : planned_.front().duration());
}

Joints MotionController::first_ends() const {
  if (!braking_) return planned_.front().end();
  return planned_.front().at(braking_->from + braking_->length / 2).position;
}

void MotionController::finish_until(runtime::Time when) {
  while (!planned_.empty() && when >= begun_ + first_takes()) {
    corrections_.open(first_ends(), tool_);
    still_since_ = begun_ += first_takes();
    planned_.pop_front();
    braking_.reset();
  }
}

SetPoint MotionController::at(runtime::Time when) {
  finish_until(when);
  if (planned_.empty()) return corrections_.at(when);
  const double elapsed = in_seconds(when - begun_);
  if (!braking_) return planned_.front().at(elapsed);
  const double part = std::clamp((elapsed - braking_->from) / braking_->length, 0.0, 1.0);
  const SpeedLaw::State ramp = unit_ramp(part);
  const double rate = 1 - ramp.speed;
  const SetPoint point = planned_.front().at(braking_->from + braking_->length * (part - ramp.way));
  return {point.position, rate * point.speed,
          rate * rate * point.acceleration - ramp.acceleration / braking_->length * point.speed};
}

runtime::Time MotionController::planned_end(runtime::Time when) const {
  if (planned_.empty()) return when;
  runtime::Time end = begun_ + first_takes();
  for (std::size_t i = 1; i < planned_.size(); ++i) end += time_of(planned_[i].duration());
  return std::max(end, when);
}

bool MotionController::idle(runtime::Time when) const {
  return planned_end(when) <= when && corrections_.idle(when);
}

Joints MotionController::goal(runtime::Time when) {
  finish_until(when);
  if (planned_.empty()) return corrections_.goal_joints();
  return planned_.size() == 1 ? first_ends() : planned_.back().end();
}

std::optional<Refusal> MotionController::busy(runtime::Time when) const {
  if (!corrections_.idle(when)) return Refusal{Refusal::Cause::busy, 0, "corrections are still being moved"};
  if (planned_.size() == queue_limit)
    return Refusal{Refusal::Cause::busy, 0,
                   std::to_string(queue_limit) + " motions are waiting to be made already"};
  return std::nullopt;
}

std::optional<Refusal> MotionController::accept(Plan plan, runtime::Time when) {
  if (const auto* refusal = std::get_if<Refusal>(&plan)) return *refusal;
  if (planned_.empty()) begun_ = when;
  planned_.push_back(std::move(std::get<PlannedMotion>(plan)));
  return std::nullopt;
}

std::optional<Refusal> MotionController::move_joints(const Joints& goal_joints, const MotionSpeed& speed,
                                                     runtime::Time when) {
  finish_until(when);
  if (auto refusal = busy(when)) return refusal;
  return accept(plan_joint_motion(goal(when), goal_joints, speed), when);
}

std::optional<Refusal> MotionController::move_to(const Pose& goal_pose, Configuration configuration,
                                                 const MotionSpeed& speed, runtime::Time when) {
  const InverseSolution solution = inverse_tool(goal_pose, tool_, configuration, goal(when));
  if (auto refusal = refusal_of(solution)) return refusal;
  return move_joints(solution.q, speed, when);
}

std::optional<Refusal> MotionController::move_straight(const Pose& goal_pose, const MotionSpeed& speed,
                                                       runtime::Time when) {
  finish_until(when);
  if (auto refusal = busy(when)) return refusal;
  return accept(plan_straight_motion(goal(when), goal_pose, tool_, speed), when);
}

std::optional<std::string> MotionController::correct(const Correction& correction, CorrectionFrame frame,
                                                     runtime::Time begin, bool cumulative) {
  if (!planned_.empty()) return "the arm is still making a motion that VAL gave it";
  return corrections_.add(correction, frame, begin, cumulative);
}

void MotionController::open_corrections(runtime::Time when) {
  corrections_.open(at(when).position, tool_);
}

void MotionController::stop(runtime::Time when) {
  finish_until(when);
  if (planned_.empty()) return corrections_.stop(when);
  planned_.resize(1, planned_.front());
  if (braking_) return;
  const double elapsed = in_seconds(when - begun_);
  if (elapsed <= 0) {
    planned_.clear();
    return;
  }
  const SpeedLaw& law = planned_.front().law();
  const double part = law.top_speed() > 0 ? law.at(elapsed).speed / law.top_speed() : 0;
  braking_ = {elapsed, std::max(least_braking, law.ramp() * part)};
}

void MotionController::hold(const Joints& q) {
  planned_.clear();
  braking_.reset();
  corrections_.open(q, tool_);
}

bool MotionController::set_tool(const Pose& tool, runtime::Time when) {
  finish_until(when);
  if (!planned_.empty() || !corrections_.stands(when)) return false;
  tool_ = tool;
  corrections_.open(corrections_.goal_joints(), tool);
  return true;
}

}  // namespace pal::sim
