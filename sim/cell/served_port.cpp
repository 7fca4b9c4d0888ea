#include "sim/cell/served_port.hpp"

#include "runtime/drivers/gripper/driver.hpp"
#include "sim/cell/corrected_arm.hpp"
#include "sim/cell/device_views.hpp"
#include "sim/devices/alter_emulator.hpp"
#include "sim/devices/force_torque_emulator.hpp"
#include "sim/devices/gripper_emulator.hpp"
#include "sim/devices/range_finder_emulator.hpp"
#include "sim/val/controller.hpp"

namespace pal::sim {
namespace {

/// The robot's controller with both of its lines.
struct ServedController {
  ServedController(runtime::drivers::Timeline& timeline, runtime::drivers::Link& terminal,
                   runtime::drivers::Link& alter_line, Workcell& workcell)
      : arm(workcell),
        alter(timeline, alter_line, arm),
        val(timeline, terminal, workcell, &alter),
        fault(workcell.on_fault([this](const ArmFault&) { alter.arm_has_stopped(); })) {
    val.store().locations = workcell.locations();
    val.greet();
  }

  CorrectedArm arm;
  AlterEmulator alter;
  val::Controller val;
  std::shared_ptr<void> fault;
};

}  // namespace

std::vector<ServedPort> served_ports() {
  return {
      {"force-torque",
       "the ATI force-torque sensor",
       {{"", ForceTorqueEmulatorOptions{}.line}},
       [](auto& timeline, const auto& links, auto& workcell, auto seed) {
         ForceTorqueEmulatorOptions options;
         options.seed = seed;
         return std::make_shared<ForceTorqueEmulator>(
             timeline, *links[0], [&workcell] { return workcell.wrench(); }, options);
       }},
      {"gripper",
       "the gripper's feedback",
       {{"", runtime::drivers::gripper::line}},
       [](auto& timeline, const auto& links, auto& workcell, auto seed) {
         GripperEmulatorOptions gripper;
         gripper.seed = seed;
         return std::make_shared<GripperEmulator>(
             timeline, *links[0], [&workcell] { return gripper_state(workcell); }, gripper);
       },
       ToolKind::gripper,
       "parts"},
      {"range-finder",
       "the laser range finder, at the tool's tip",
       {{"", runtime::drivers::range_finder::line}},
       [](auto& timeline, const auto& links, auto& workcell, auto seed) {
         RangeFinderEmulatorOptions finder;
         finder.seed = seed;
         return std::make_shared<RangeFinderEmulator>(timeline, *links[0], range_view(workcell), finder);
       },
       ToolKind::range_finder,
       "flat"},
      {"val",
       "the VAL II controller: its terminal, and its ALTER line beside it",
       {{"val", val::terminal_line}, {"alter", runtime::drivers::alter::line}},
       [](auto& timeline, const auto& links, auto& workcell, auto) {
         return std::make_shared<ServedController>(timeline, *links[0], *links[1], workcell);
       }},
  };
}

}  // namespace pal::sim
