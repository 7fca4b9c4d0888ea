// The workcell's arm, as its controller's ALTER port moves it.
#pragma once

#include "sim/devices/alter_emulator.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

class CorrectedArm final : public AlterArm {
 public:
  /// `keeps_first_turn`: corrections in the tool's frame refer to that frame as it was at opening, as on the
  /// real controller. Otherwise they refer to the frame as corrections have turned it. The workcell outlives
  /// the arm.
  explicit CorrectedArm(Workcell& workcell, bool keeps_first_turn = false)
      : workcell_(workcell), keeps_first_turn_(keeps_first_turn) {}

  std::string open(const AlterMode& mode) override;
  std::optional<std::string> move(const Correction& correction, runtime::Time begin) override;
  void stop() override { workcell_.stop(); }
  std::string fault() const override { return workcell_.fault() ? workcell_.fault()->text : std::string(); }
  bool moving() const override { return !workcell_.idle(); }
  /// The tip of the tool that VAL was told of, by the encoders.
  Pose tool() const override;

 private:
  Workcell& workcell_;
  bool keeps_first_turn_;
  bool cumulative_ = true;
  CorrectionFrame frame_ = CorrectionFrame::tool;
};

}  // namespace pal::sim
