#include "sim/cell/corrected_arm.hpp"

#include "sim/controller/motion_controller.hpp"

namespace pal::sim {

std::string CorrectedArm::open(const AlterMode& mode) {
  if (!workcell_.idle()) return "the arm is moving";
  frame_ = keeps_first_turn_ ? CorrectionFrame::tool_at_open : CorrectionFrame::tool;
  if (mode.world) frame_ = CorrectionFrame::world;
  if (mode.joints) frame_ = CorrectionFrame::joints;
  cumulative_ = mode.cumulative;
  workcell_.motion().open_corrections(workcell_.now());
  return {};
}

std::optional<std::string> CorrectedArm::move(const Correction& correction, runtime::Time begin) {
  if (workcell_.fault()) return workcell_.fault()->text;
  auto refused = workcell_.motion().correct(correction, frame_, begin, cumulative_);
  if (refused) workcell_.stop();
  return refused;
}

Pose CorrectedArm::tool() const {
  return tool_pose(workcell_.encoder_joints(), workcell_.motion().tool());
}

}  // namespace pal::sim
