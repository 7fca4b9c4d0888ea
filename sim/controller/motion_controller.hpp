// The only owner of the set-point: planned motions (VAL) and corrections (ALTER) take turns.
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "pal/runtime/device.hpp"
#include "sim/controller/planner.hpp"
#include "sim/controller/trajectory.hpp"

namespace pal::sim {

/// Planned motions follow one another, each from rest to rest. Corrections are accepted while no planned
/// motion is under way, and planned motions while no correction is; otherwise they are refused.
class MotionController {
 public:
  /// The arm stands still at `start`. `period`: how long a correction takes. `tool`: from the flange to
  /// the tip.
  MotionController(const Joints& start, runtime::Time period, const Pose& tool = pad_tool());

  /// The set-point at `when`; instants must not run backwards.
  SetPoint at(runtime::Time when);
  /// Whether no motion is left to make.
  bool idle(runtime::Time when) const;
  /// When the last planned motion that was accepted ends; `when` if there is none.
  runtime::Time planned_end(runtime::Time when) const;

  /// When the last planned motion ended that has ended.
  runtime::Time still_since() const { return still_since_; }

  /// Joint-interpolated, to these joints. After the motions accepted before, or from `when` on.
  std::optional<Refusal> move_joints(const Joints& goal, const MotionSpeed& speed, runtime::Time when);
  /// Joint-interpolated, to where the tip is at `goal` (in frame 0) in `configuration`.
  std::optional<Refusal> move_to(const Pose& goal, Configuration configuration, const MotionSpeed& speed,
                                 runtime::Time when);
  /// In a straight line; the configuration stays.
  std::optional<Refusal> move_straight(const Pose& goal, const MotionSpeed& speed, runtime::Time when);

  /// A correction, as Trajectory::add.
  std::optional<std::string> correct(const Correction& correction, CorrectionFrame frame, runtime::Time begin,
                                     bool cumulative = true);
  /// Corrections count from where the arm is told to be at `when`.
  void open_corrections(runtime::Time when);

  /// Slows down on the planned path, and drops the motions after it. Corrections that were not moved are
  /// dropped at once.
  void stop(runtime::Time when);
  /// Stops at once and stays at `q`, because the arm has met something or does not follow.
  void hold(const Joints& q);

  /// The joint angles after all accepted motions.
  Joints goal(runtime::Time when);

  const Pose& tool() const { return tool_; }
  /// Another tool: a pose in the flange's frame; corrections count from here then. False while the arm moves.
  bool set_tool(const Pose& tool, runtime::Time when);

 private:
  // A planned motion that is told to stop goes on along its path in a time that slows down to a stand.
  struct Braking {
    double from = 0;    // s of the motion's own time, when braking began
    double length = 0;  // s of real time
  };

  std::optional<Refusal> busy(runtime::Time when) const;
  std::optional<Refusal> accept(Plan plan, runtime::Time when);
  runtime::Time first_takes() const;
  Joints first_ends() const;
  void finish_until(runtime::Time when);

  Pose tool_;
  std::deque<PlannedMotion> planned_;  // the first is being made
  runtime::Time begun_{};              // of the first
  runtime::Time still_since_{};
  std::optional<Braking> braking_;  // of the first
  Trajectory corrections_;
};

}  // namespace pal::sim
