// The state of a VAL controller: what instructions read and change.
#pragma once

#include <optional>

#include "runtime/drivers/timeline.hpp"
#include "sim/devices/alter_control.hpp"
#include "sim/val/arm.hpp"
#include "sim/val/expression.hpp"
#include "sim/val/store.hpp"

namespace pal::sim::val {

/// How fast a program's motions are: per cent of the arm's greatest speeds, or of the tip in mm/s.
struct ProgramSpeed {
  double percent = 100;
  std::optional<double> straight;
};

struct Machine {
  runtime::drivers::Timeline& timeline;
  Arm& arm;
  Hand* hand = nullptr;           // null: there is none
  AlterControl* alter = nullptr;  // null: there is none
  Store store{};

  Pose base = Pose::Identity();  // of all locations, in frame 0
  double monitor_speed = 100;    // per cent; on top of what a program wants
  ProgramSpeed program_speed{};
  std::optional<ProgramSpeed> next_speed = std::nullopt;  // of the next motion only
  // Wished for by RIGHTY …, of the next joint-interpolated motion.
  std::optional<bool> righty = std::nullopt, above = std::nullopt, flip = std::nullopt;
  bool attached = false;  // the arm belongs to a program that runs

  /// Where the tip is, or will be after the motions that were accepted, relative to the base.
  Pose here(const Joints& q) const { return base.inverse() * tool_pose(q, arm.tool()); }
  Values values() const { return {store, here(arm.goal())}; }
};

}  // namespace pal::sim::val
