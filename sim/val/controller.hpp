// A VAL controller on the workcell: what is at the far end of the terminal's line.
#pragma once

#include "runtime/drivers/link.hpp"
#include "runtime/drivers/timeline.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/val/terminal.hpp"
#include "sim/val/workcell_arm.hpp"

namespace pal::sim::val {

/// The line of the terminal.
inline constexpr runtime::drivers::LineSpeed terminal_line{9600, 10};

/// Takes bytes and gives bytes. The caller that brings time on brings the workcell to an instant before the
/// timeline's actions of that instant.
class Controller {
 public:
  /// Everything given outlives the controller. `alter` null: it has no ALTER port. It has a hand if the
  /// workcell has one.
  Controller(runtime::drivers::Timeline& timeline, runtime::drivers::Link& link, Workcell& workcell,
             AlterControl* alter = nullptr);
  ~Controller();
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  /// Locations, numbers and programs, to be filled before or read after.
  Store& store() { return machine_.store; }
  /// Shows what a terminal shows when the machine is switched on.
  void greet() { terminal_.monitor().greet(); }

 private:
  WorkcellArm arm_;
  WorkcellHand hand_;
  Machine machine_;
  Terminal terminal_;
};

}  // namespace pal::sim::val
