// The emulated devices of a workcell, each at the far end of a line.
#pragma once

#include <cstdint>
#include <memory>

#include "runtime/cost_policy.hpp"
#include "runtime/drivers/link.hpp"
#include "runtime/drivers/wire.hpp"
#include "sim/val/terminal.hpp"
#include "sim/val/workcell_arm.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

inline constexpr runtime::LineSpeed val_speed{9600, 10};
inline constexpr runtime::LineSpeed force_torque_speed{38400, 10};
inline constexpr runtime::LineSpeed gripper_speed{38400, 10};

/// Each is alive as long as the answer is. What they are given outlives them. `times`: which times of their
/// intervals they take.
std::shared_ptr<void> emulate_force_torque(runtime::Timeline& timeline, runtime::Link& link,
                                           Workcell& workcell, std::uint64_t seed,
                                           runtime::CostPolicy times = runtime::CostPolicy::random);
std::shared_ptr<void> emulate_gripper(runtime::Timeline& timeline, runtime::Link& link, Workcell& workcell,
                                      std::uint64_t seed,
                                      runtime::CostPolicy times = runtime::CostPolicy::random);
std::shared_ptr<void> emulate_range_finder(runtime::Timeline& timeline, runtime::Link& link,
                                           Workcell& workcell, std::uint64_t seed);

/// The VAL controller with its arm, its hand if the workcell has a gripper, and its ALTER port if it is given
/// one.
class EmulatedVal {
 public:
  EmulatedVal(Workcell& workcell, runtime::Timeline& timeline, runtime::Link& link, AlterControl* alter);

  val::Machine& machine() { return machine_; }

 private:
  val::WorkcellArm arm_;
  val::WorkcellHand hand_;
  val::Machine machine_;
  val::Terminal terminal_;
};

}  // namespace pal::sim
