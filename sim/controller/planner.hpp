// Plans motions: what the joints do on the way to a goal, or why it cannot be reached.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/arm/kinematics.hpp"
#include "sim/controller/servo.hpp"
#include "sim/controller/speed_law.hpp"

namespace pal::sim {

/// Why a motion is refused. `text` is a clause without a full stop, for people.
struct Refusal {
  enum class Cause { too_far, too_near, joint_range, joint_speed, tool_speed, busy };
  Cause cause = Cause::busy;
  std::size_t joint = 0;  // 0 to 5, of joint_range and joint_speed
  std::string text;
};

/// The refusal that an inverse solution amounts to; nothing if there is none.
std::optional<Refusal> refusal_of(const InverseSolution& solution);
/// The joint that turns faster than it can, if one does. `speeds` in rad/s.
std::optional<Refusal> too_fast(const Joints& speeds);

/// "0.536 m/s, its limit is 0.5 m/s": with as many figures as tell the two apart.
std::string beyond_limit(double value, double limit, const std::string& unit);

/// How fast a motion is to be. Accelerations are always the arm's own.
struct MotionSpeed {
  double part = 1;                 // of the arm's greatest speeds, in (0, 1]
  std::optional<double> straight;  // of the tip on a straight line, m/s; takes the place of `part` there
};

/// Greatest accelerations: of the tip along a straight line, of the tool's turn, of each joint.
inline constexpr double straight_line_acceleration = 2.0;                                   // m/s^2
inline constexpr double turn_speed = 2.0;                                                   // rad/s
inline constexpr double turn_acceleration = 8.0;                                            // rad/s^2
inline constexpr std::array<double, joint_count> joint_accelerations{5, 4, 8, 20, 20, 20};  // rad/s^2

/// A motion as planned, from rest to rest.
class PlannedMotion {
 public:
  /// `knots`: the joints at even distances along the path, at least two; `law` for a path of length 1.
  PlannedMotion(std::vector<Joints> knots, SpeedLaw law);

  double duration() const { return law_.duration(); }  // s
  const SpeedLaw& law() const { return law_; }
  const Joints& begin() const { return knots_.front(); }
  const Joints& end() const { return knots_.back(); }
  SetPoint at(double seconds) const;

 private:
  Joints slope(std::size_t knot) const;

  std::vector<Joints> knots_;
  SpeedLaw law_;
};

using Plan = std::variant<PlannedMotion, Refusal>;

/// All joints begin and end together. Contract: `from` is within the joints' limits.
Plan plan_joint_motion(const Joints& from, const Joints& to, const MotionSpeed& speed);

/// The tip stands at `tool` in the flange's frame. It goes in a straight line to `goal` in frame 0, while the
/// tool turns evenly about one axis. The configuration stays. The whole path is checked. The motion is
/// refused if a pose is out of reach, or if a joint leaves its range. Near a singularity it is refused if a
/// joint would turn faster than it can.
Plan plan_straight_motion(const Joints& from, const Pose& goal, const Pose& tool, const MotionSpeed& speed);

}  // namespace pal::sim
