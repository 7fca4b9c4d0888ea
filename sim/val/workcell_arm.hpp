// The workcell's arm, as VAL commands it.
#pragma once

#include "runtime/timeline.hpp"
#include "sim/controller/motion_controller.hpp"
#include "sim/val/arm.hpp"
#include "sim/workcell.hpp"

namespace pal::sim::val {

class WorkcellArm final : public Arm {
 public:
  /// Both outlive it. The workcell is brought to the clock's time before anything happens by it.
  WorkcellArm(Workcell& workcell, const runtime::Timeline& timeline);

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
  const runtime::Timeline& timeline_;
};

}  // namespace pal::sim::val
