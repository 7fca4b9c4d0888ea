#include "sim/val/controller.hpp"

namespace pal::sim::val {

Controller::Controller(runtime::drivers::Timeline& timeline, runtime::drivers::Link& link, Workcell& workcell,
                       AlterControl* alter)
    : arm_(workcell, timeline),
      hand_(workcell, timeline),
      machine_{.timeline = timeline,
               .arm = arm_,
               .hand = workcell.tool_kind() == ToolKind::gripper ? &hand_ : nullptr,
               .alter = alter},
      terminal_(link, machine_) {}

}  // namespace pal::sim::val
