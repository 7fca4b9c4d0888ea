#include "sim/cell/emulated.hpp"

#include "sim/devices/force_torque_emulator.hpp"
#include "sim/devices/gripper_emulator.hpp"
#include "sim/devices/range_finder_emulator.hpp"

namespace pal::sim {
namespace {

/// Narrows an interval to the end that is asked for.
void choose(runtime::CostPolicy times, runtime::Time& shortest, runtime::Time& longest) {
  if (times == runtime::CostPolicy::worst) shortest = longest;
  if (times == runtime::CostPolicy::best) longest = shortest;
}

}  // namespace

std::shared_ptr<void> emulate_force_torque(runtime::Timeline& timeline, runtime::Link& link,
                                           Workcell& workcell, std::uint64_t seed,
                                           runtime::CostPolicy times) {
  ForceTorqueEmulatorOptions options;
  options.seed = seed;
  options.line = force_torque_speed;
  choose(times, options.shortest_conversion, options.longest_conversion);
  return std::make_shared<ForceTorqueEmulator>(
      timeline, link, [&workcell] { return workcell.wrench(); }, options);
}

std::shared_ptr<void> emulate_gripper(runtime::Timeline& timeline, runtime::Link& link, Workcell& workcell,
                                      std::uint64_t seed, runtime::CostPolicy times) {
  GripperEmulatorOptions options;
  options.seed = seed;
  choose(times, options.shortest_wait, options.longest_wait);
  const auto state = [&workcell] {
    return GripperState{workcell.gripper_width(), workcell.gripper_force(), workcell.holds_part()};
  };
  return std::make_shared<GripperEmulator>(timeline, link, state, options);
}

std::shared_ptr<void> emulate_range_finder(runtime::Timeline& timeline, runtime::Link& link,
                                           Workcell& workcell, std::uint64_t seed) {
  RangeFinderEmulatorOptions options;
  options.seed = seed;
  const RangeView view{
      [&workcell] { return workcell.tool(); },
      [&workcell](const auto& origin, const auto& direction) { return workcell.cast(origin, direction); }};
  return std::make_shared<RangeFinderEmulator>(timeline, link, view, options);
}

EmulatedVal::EmulatedVal(Workcell& workcell, runtime::Timeline& timeline, runtime::Link& link,
                         AlterControl* alter)
    : arm_(workcell, timeline),
      hand_(workcell, timeline),
      machine_{.timeline = timeline,
               .arm = arm_,
               .hand = workcell.tool_kind() == ToolKind::gripper ? &hand_ : nullptr,
               .alter = alter,
               .store = {}},
      terminal_(link, machine_) {}

}  // namespace pal::sim
