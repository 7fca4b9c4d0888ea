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

/// ALTER without VAL: whatever comes in while it is closed opens it, in the tool's frame.
class ServedAlter final : private runtime::Link, private runtime::LinkUser {
 public:
  ServedAlter(runtime::Timeline& timeline, runtime::Link& line, Workcell& workcell)
      : line_(line), arm_(workcell), port_(timeline, *this, arm_) {
    line_.connect(this);
  }
  ServedAlter(const ServedAlter&) = delete;
  ServedAlter& operator=(const ServedAlter&) = delete;
  ~ServedAlter() override { line_.connect(nullptr); }

 private:
  void connect(LinkUser* user) override { user_ = user; }
  void write(runtime::Bytes bytes) override { line_.write(bytes); }
  void on_bytes(runtime::Bytes bytes) override {
    if (port_.is_open()) return user_->on_bytes(bytes);
    port_.close();
    port_.open({});
  }
  void on_break(std::string_view reason) override { user_->on_break(reason); }

  runtime::Link& line_;
  LinkUser* user_ = nullptr;
  CorrectedArm arm_;
  AlterEmulator port_;
};

}  // namespace

std::vector<ServedPort> served_ports() {
  return {
      {"alter", "the controller's ALTER port; any byte opens it, an answer each 28 ms keeps it open",
       runtime::alter::line,
       [](auto& timeline, auto& link, auto& workcell, auto) {
         return std::make_shared<ServedAlter>(timeline, link, workcell);
       }},
      {"force-torque", "the ATI force-torque sensor", ForceTorqueEmulatorOptions{}.line,
       [](auto& timeline, auto& link, auto& workcell, auto seed) {
         ForceTorqueEmulatorOptions options;
         options.seed = seed;
         return std::make_shared<ForceTorqueEmulator>(
             timeline, link, [&workcell] { return workcell.wrench(); }, options);
       }},
      {"gripper", "the gripper's feedback", runtime::gripper::line,
       [](auto& timeline, auto& link, auto& workcell, auto seed) {
         GripperEmulatorOptions gripper;
         gripper.seed = seed;
         return std::make_shared<GripperEmulator>(
             timeline, link, [&workcell] { return gripper_state(workcell); }, gripper);
       },
       ToolKind::gripper, "parts"},
      {"range-finder", "the laser range finder, at the tool's tip", runtime::range_finder::line,
       [](auto& timeline, auto& link, auto& workcell, auto seed) {
         RangeFinderEmulatorOptions finder;
         finder.seed = seed;
         return std::make_shared<RangeFinderEmulator>(timeline, link, range_view(workcell), finder);
       },
       ToolKind::range_finder, "flat"},
      {"val", "the VAL II controller's terminal, without an ALTER port", val::terminal_line,
       [](auto& timeline, auto& link, auto& workcell, auto) {
         auto controller = std::make_shared<val::Controller>(timeline, link, workcell);
         controller->greet();
         return controller;
       }},
  };
}

}  // namespace pal::sim
