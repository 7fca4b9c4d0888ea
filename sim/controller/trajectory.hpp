// The set-point generator: corrections become joint set-points, interpolated over 28 ms each, or are refused.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "pal/runtime/device.hpp"
#include "sim/controller/correction.hpp"
#include "sim/controller/servo.hpp"

namespace pal::sim {

/// Keeps the pose that the corrections add up to and moves the joints there, each evenly over one period.
class Trajectory {
 public:
  /// The arm stands still at `start`. `period`: how long each correction takes. `tool`: from the flange to
  /// the tip.
  Trajectory(const Joints& start, runtime::Time period, const Pose& tool = pad_tool());

  /// Adds a relative motion, to be made from `begin` on or after those before it, whichever is later.
  /// Refused, with the reason, when the pose is out of reach, a joint would leave its range, or the motion is
  /// faster than the arm. Not cumulative: relative to the pose at opening, not to the corrections before it.
  /// In the frame of the joints they always add up.
  std::optional<std::string> add(const Correction& correction, CorrectionFrame frame, runtime::Time begin,
                                 bool cumulative = true);

  /// The set-point at `when`; instants must not run backwards.
  SetPoint at(runtime::Time when);

  /// Drops what has not been moved at `when` and stays there.
  void stop(runtime::Time when);

  /// Drops what has not been moved and stays at `q`.
  void hold(const Joints& q);

  /// Begins again at `q`, with another tool: what CorrectionFrame::tool_at_open and corrections that are not
  /// cumulative count from.
  void open(const Joints& q, const Pose& tool);

  bool idle(runtime::Time when) const;
  /// Whether the remaining corrections are no motion: ALTER is answered with no motion.
  bool stands(runtime::Time when) const;

  /// Where all corrections so far lead.
  const Pose& goal() const { return goal_; }
  const Joints& goal_joints() const { return goal_joints_; }

 private:
  std::optional<std::string> add(const Pose& goal, const Joints& joints, runtime::Time begin);
  std::optional<std::string> turn_joints(const Correction& correction, runtime::Time begin);

  struct Segment {
    runtime::Time begin{};
    Joints from = Joints::Zero();
    Joints to = Joints::Zero();
  };
  // One in motion, one accepted meanwhile, one for a driver that is early: a fixed few, so that nothing
  // allocates.
  static constexpr std::size_t capacity = 4;

  runtime::Time period_;
  Pose tool_;
  Configuration configuration_;
  Pose opened_;
  Pose goal_;
  Joints goal_joints_;
  std::array<Segment, capacity> segments_;
  std::size_t count_ = 0;
  Joints resting_;
};

}  // namespace pal::sim
