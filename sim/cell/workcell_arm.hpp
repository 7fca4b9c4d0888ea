// The workcell's arm, as the ports of its controller move it.
#pragma once

#include "sim/devices/alter_emulator.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

class WorkcellArm final : public AlterArm {
 public:
  /// `keeps_first_turn`: corrections in the tool's frame are meant in that frame as it was at opening, as on
  /// the real controller; otherwise in the frame as corrections have turned it. The workcell outlives the
  /// arm.
  explicit WorkcellArm(Workcell& workcell, bool keeps_first_turn = false)
      : workcell_(workcell), keeps_first_turn_(keeps_first_turn) {}

  std::string open(const AlterMode& mode) override;
  std::optional<std::string> move(const Correction& correction, runtime::Time begin) override;
  void stop() override { workcell_.stop(); }
  std::string fault() const override { return {}; }
  bool moving() const override { return !workcell_.idle(); }
  Pose tool() const override { return workcell_.tool(); }

 private:
  Workcell& workcell_;
  bool keeps_first_turn_;
  CorrectionFrame frame_ = CorrectionFrame::tool;
};

}  // namespace pal::sim
