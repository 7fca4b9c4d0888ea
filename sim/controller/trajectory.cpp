#include "sim/controller/trajectory.hpp"

#include <algorithm>
#include <cmath>

#include "sim/controller/planner.hpp"

namespace pal::sim {
namespace {

double seconds(runtime::Time time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

Trajectory::Trajectory(const Joints& start, runtime::Time period, const Pose& tool)
    : period_(period),
      tool_(tool),
      configuration_(configuration_of(start)),
      opened_(tool_pose(start, tool)),
      goal_(opened_),
      goal_joints_(start),
      resting_(start) {}

std::optional<std::string> Trajectory::add(const Correction& correction, CorrectionFrame frame,
                                           runtime::Time begin, bool cumulative) {
  if (frame == CorrectionFrame::joints) return turn_joints(correction, begin);
  const Pose goal = corrected(cumulative ? goal_ : opened_, correction, frame, opened_);
  const InverseSolution solution = next_on_path(goal, tool_, configuration_, goal_joints_);
  if (const auto refusal = refusal_of(solution)) return refusal->text;
  return add(goal, solution.q, begin);
}

std::optional<std::string> Trajectory::turn_joints(const Correction& correction, runtime::Time begin) {
  InverseSolution solution;
  const std::array by{correction.dx, correction.dy, correction.dz,
                      correction.rx, correction.ry, correction.rz};
  for (std::size_t i = 0; i < joint_count; ++i) {
    const auto joint = static_cast<Eigen::Index>(i);
    solution.q[joint] = goal_joints_[joint] + radians(by[i]);
    const bool within =
        solution.q[joint] >= puma_limits[i].lower && solution.q[joint] <= puma_limits[i].upper;
    if (within || by[i] == 0 || solution.problem != InverseProblem::none) continue;
    solution.problem = InverseProblem::over_limit;
    solution.joint = i;
  }
  if (const auto refusal = refusal_of(solution)) return refusal->text;
  const auto refused = add(tool_pose(solution.q, tool_), solution.q, begin);
  if (!refused) configuration_ = configuration_of(solution.q);
  return refused;
}

std::optional<std::string> Trajectory::add(const Pose& goal, const Joints& joints, runtime::Time begin) {
  const double distance = (goal.translation() - goal_.translation()).norm();
  if (distance > straight_line_speed * seconds(period_))
    return "the tool would move at " + beyond_limit(distance / seconds(period_), straight_line_speed, "m/s");
  if (const auto refusal = too_fast((joints - goal_joints_) / seconds(period_))) return refusal->text;
  if (count_ == capacity) return "corrections come faster than they can be moved";
  if (count_ > 0) begin = std::max(begin, segments_[count_ - 1].begin + period_);
  segments_[count_++] = {begin, goal_joints_, joints};
  goal_ = goal;
  goal_joints_ = joints;
  return std::nullopt;
}

SetPoint Trajectory::at(runtime::Time when) {
  while (count_ > 0 && when >= segments_[0].begin + period_) {
    resting_ = segments_[0].to;
    std::move(segments_.begin() + 1, segments_.begin() + static_cast<std::ptrdiff_t>(count_),
              segments_.begin());
    --count_;
  }
  if (count_ == 0 || when < segments_[0].begin) return {resting_, Joints::Zero()};
  const Segment& segment = segments_[0];
  const double part = seconds(when - segment.begin) / seconds(period_);
  const Joints step = segment.to - segment.from;
  return {segment.from + part * step, step / seconds(period_)};
}

void Trajectory::stop(runtime::Time when) {
  hold(at(when).position);
}

void Trajectory::hold(const Joints& q) {
  resting_ = q;
  count_ = 0;
  goal_joints_ = resting_;
  goal_ = tool_pose(resting_, tool_);
}

void Trajectory::open(const Joints& q, const Pose& tool) {
  tool_ = tool;
  configuration_ = configuration_of(q);
  hold(q);
  opened_ = goal_;
}

bool Trajectory::idle(runtime::Time when) const {
  return count_ == 0 || when >= segments_[count_ - 1].begin + period_;
}

bool Trajectory::stands(runtime::Time when) const {
  return std::all_of(
      segments_.begin(), segments_.begin() + static_cast<std::ptrdiff_t>(count_),
      [&](const Segment& segment) { return when >= segment.begin + period_ || segment.from == segment.to; });
}

}  // namespace pal::sim
