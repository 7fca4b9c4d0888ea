#include "sim/cell/workcell_arm.hpp"

namespace pal::sim {

std::string WorkcellArm::open(const AlterMode& mode) {
  if (!mode.cumulative) return "this controller's corrections add up; open ALTER as cumulative";
  if (!workcell_.idle()) return "the arm is moving";
  frame_ = keeps_first_turn_ ? CorrectionFrame::tool_at_open : CorrectionFrame::tool;
  if (mode.world) frame_ = CorrectionFrame::world;
  return {};
}

std::optional<std::string> WorkcellArm::move(const Correction& correction, runtime::Time begin) {
  return workcell_.move(correction, frame_, begin);
}

}  // namespace pal::sim
