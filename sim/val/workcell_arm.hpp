// The workcell's arm and hand, as VAL commands them.
#pragma once

#include "runtime/drivers/timeline.hpp"
#include "sim/controller/motion_controller.hpp"
#include "sim/val/arm.hpp"
#include "sim/workcell.hpp"

namespace pal::sim::val {

class WorkcellArm final : public Arm {
 public:
  /// Both outlive it. The workcell is brought to the clock's time before anything happens by it.
  WorkcellArm(Workcell& workcell, const runtime::drivers::Timeline& timeline);

  Joints joints() const override;
  Joints goal() const override;
  Pose tool() const override;
  bool set_tool(const Pose& tool) override;
  std::optional<Refusal> move_joints(const Joints& goal, const MotionSpeed& speed) override;
  std::optional<Refusal> move_to(const Pose& goal, Configuration configuration,
                                 const MotionSpeed& speed) override;
  std::optional<Refusal> move_straight(const Pose& goal, const MotionSpeed& speed) override;
  void stop() override;
  bool at_rest() const override;
  runtime::Time look_again() const override;
  std::string fault() const override;
  std::string clear_fault() override;

 private:
  runtime::Time now() const { return timeline_.now(); }

  Workcell& workcell_;
  const runtime::drivers::Timeline& timeline_;
};

/// The workcell's gripper. Only where the workcell has one.
class WorkcellHand final : public Hand {
 public:
  WorkcellHand(Workcell& workcell, const runtime::drivers::Timeline& timeline)
      : workcell_(workcell), timeline_(timeline) {}

  void open() override;
  void close() override;
  bool at_rest() const override;

 private:
  Workcell& workcell_;
  const runtime::drivers::Timeline& timeline_;
  runtime::Time commanded_{};
  // Where the fingers were when they were last seen to move, and when that was.
  mutable double width_ = 0;
  mutable runtime::Time still_since_{};
};

}  // namespace pal::sim::val
