#include "sim/controller/planner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace pal::sim {
namespace {

// Between two knots of a straight line; what cubic interpolation errs on it is far below an encoder's count.
constexpr double knot_distance = 1e-3;       // m
constexpr double knot_turn = radians(0.25);  // rad
constexpr double least_knots = 17;
constexpr double look_each = 2e-3;  // s, when joint speeds are checked

std::string joint_text(std::size_t joint) {
  return "joint " + std::to_string(joint + 1);
}

std::string figure(double value, int digits = 3) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

}  // namespace

std::optional<Refusal> refusal_of(const InverseSolution& solution) {
  switch (solution.problem) {
    case InverseProblem::too_far:
      return Refusal{Refusal::Cause::too_far, 0, "the tool would be out of the arm's reach"};
    case InverseProblem::too_near:
      return Refusal{Refusal::Cause::too_near, 0, "the tool would be too near to the arm's own axis"};
    case InverseProblem::over_limit: {
      const JointLimits& limits = puma_limits[solution.joint];
      return Refusal{Refusal::Cause::joint_range, solution.joint,
                     joint_text(solution.joint) + " would leave its range of " +
                         figure(degrees(limits.lower)) + " to " + figure(degrees(limits.upper)) + " degrees"};
    }
    case InverseProblem::none:
      break;
  }
  return std::nullopt;
}

std::string beyond_limit(double value, double limit, const std::string& unit) {
  constexpr int most = 9;
  int digits = 3;
  while (digits < most && figure(value, digits) == figure(limit, digits)) ++digits;
  return figure(value, digits) + " " + unit + ", its limit is " + figure(limit) + " " + unit;
}

std::optional<Refusal> too_fast(const Joints& speeds) {
  constexpr double rounding = 1 + 1e-6;
  for (std::size_t i = 0; i < joint_count; ++i) {
    const double speed = std::abs(speeds[static_cast<Eigen::Index>(i)]);
    if (speed <= puma_limits[i].speed * rounding) continue;
    return Refusal{Refusal::Cause::joint_speed, i,
                   joint_text(i) + " would turn at " + beyond_limit(speed, puma_limits[i].speed, "rad/s")};
  }
  return std::nullopt;
}

PlannedMotion::PlannedMotion(std::vector<Joints> knots, SpeedLaw law) : knots_(std::move(knots)), law_(law) {}

Joints PlannedMotion::slope(std::size_t knot) const {
  const std::size_t last = knots_.size() - 1;
  if (last == 1) return knots_[1] - knots_[0];
  // At the ends of second order as well: the parabola through three knots.
  if (knot == 0) return -1.5 * knots_[0] + 2.0 * knots_[1] - 0.5 * knots_[2];
  if (knot == last) return 1.5 * knots_[last] - 2.0 * knots_[last - 1] + 0.5 * knots_[last - 2];
  return 0.5 * (knots_[knot + 1] - knots_[knot - 1]);
}

SetPoint PlannedMotion::at(double seconds) const {
  const SpeedLaw::State state = law_.at(seconds);
  const auto pieces = static_cast<double>(knots_.size() - 1);
  const double place = state.way * pieces;
  const auto piece = std::min(static_cast<std::size_t>(std::max(place, 0.0)), knots_.size() - 2);
  const double u = place - static_cast<double>(piece);
  // Hermite's cubic on this piece.
  const Joints& p = knots_[piece];
  const Joints m = slope(piece);
  const Joints rise = knots_[piece + 1] - p;
  const Joints n = slope(piece + 1);
  const Joints c2 = 3.0 * rise - 2.0 * m - n;
  const Joints c3 = m + n - 2.0 * rise;
  const Joints first = m + u * (2.0 * c2 + 3.0 * u * c3);
  const Joints second = 2.0 * c2 + 6.0 * u * c3;
  const double rate = state.speed * pieces;
  return {p + u * (m + u * (c2 + u * c3)), rate * first,
          rate * rate * second + state.acceleration * pieces * first};
}

Plan plan_joint_motion(const Joints& from, const Joints& to, const MotionSpeed& speed) {
  double rate = std::numeric_limits<double>::infinity();
  double gain = rate;
  for (std::size_t i = 0; i < joint_count; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double way = std::abs(to[row] - from[row]);
    if (way == 0) continue;
    rate = std::min(rate, speed.part * puma_limits[i].speed / way);
    gain = std::min(gain, joint_accelerations[i] / way);
    constexpr double rounding = 1e-9;
    if (to[row] < puma_limits[i].lower - rounding || to[row] > puma_limits[i].upper + rounding)
      return *refusal_of({to, InverseProblem::over_limit, i});
  }
  if (!std::isfinite(rate)) return PlannedMotion({from, to}, SpeedLaw(0, 1, 1));
  return PlannedMotion({from, to}, SpeedLaw(1, rate, gain));
}

Plan plan_straight_motion(const Joints& from, const Pose& goal, const Pose& tool, const MotionSpeed& speed) {
  const Pose start = tool_pose(from, tool);
  const Eigen::Vector3d way = goal.translation() - start.translation();
  const Eigen::AngleAxisd turn(start.linear().transpose() * goal.linear());
  const double distance = way.norm();
  const double wanted = speed.straight.value_or(speed.part * straight_line_speed);
  if (wanted > straight_line_speed * (1 + 1e-9))
    return Refusal{Refusal::Cause::tool_speed, 0,
                   "the tool would move at " + beyond_limit(wanted, straight_line_speed, "m/s")};

  const double pieces =
      std::ceil(std::max({least_knots - 1, distance / knot_distance, turn.angle() / knot_turn}));
  const Configuration configuration = configuration_of(from);
  std::vector<Joints> knots{from};
  knots.reserve(static_cast<std::size_t>(pieces) + 1);
  for (double i = 1; i <= pieces; ++i) {
    Pose pose = Pose::Identity();
    pose.translation() = start.translation() + i / pieces * way;
    pose.linear() =
        start.linear() * Eigen::AngleAxisd(i / pieces * turn.angle(), turn.axis()).toRotationMatrix();
    const InverseSolution solution = next_on_path(pose, tool, configuration, knots.back());
    if (auto refusal = refusal_of(solution)) return *refusal;
    knots.push_back(solution.q);
  }

  constexpr double nothing = 1e-9;  // m and rad: a motion to where the arm stands
  if (distance < nothing && turn.angle() < nothing) return PlannedMotion({from, from}, SpeedLaw(0, 1, 1));
  const double part = std::min(1.0, wanted / straight_line_speed);
  const double rate = std::min(wanted / distance, part * turn_speed / turn.angle());
  const double gain = std::min(straight_line_acceleration / distance, turn_acceleration / turn.angle());
  PlannedMotion motion(std::move(knots), SpeedLaw(1, rate, gain));
  for (double t = 0; t < motion.duration(); t += look_each)
    if (auto refusal = too_fast(motion.at(t).speed)) return *refusal;
  return motion;
}

}  // namespace pal::sim
