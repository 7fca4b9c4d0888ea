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
      terminal_(link, machine_) {
  if (alter != nullptr)
    alter->on_end([this](const std::string& why) { terminal_.monitor().alter_ended(why); });
}

Controller::~Controller() {
  if (machine_.alter != nullptr) machine_.alter->on_end(nullptr);
}

}  // namespace pal::sim::val
