#include "sim/cell/workcell_arm.hpp"

#include "sim/controller/motion_controller.hpp"

namespace pal::sim {

std::string WorkcellArm::open(const AlterMode& mode) {
  if (!fault().empty()) return fault();
  if (!workcell_.idle()) return "the arm is moving";
  frame_ = keeps_first_turn_ ? CorrectionFrame::tool_at_open : CorrectionFrame::tool;
  if (mode.world) frame_ = CorrectionFrame::world;
  cumulative_ = mode.cumulative;
  workcell_.motion().open_corrections(workcell_.now());
  return {};
}

std::optional<std::string> WorkcellArm::move(const Correction& correction, runtime::Time begin) {
  return workcell_.move(correction, frame_, begin, cumulative_);
}

std::string WorkcellArm::fault() const {
  return workcell_.fault() ? workcell_.fault()->text : std::string();
}

Pose WorkcellArm::tool() const {
  return tool_pose(workcell_.joints(), workcell_.motion().tool());
}

}  // namespace pal::sim
