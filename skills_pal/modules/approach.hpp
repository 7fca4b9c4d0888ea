// Going towards a surface along the tool's Z axis, and back.
#pragma once

#include <chrono>

#include "runtime/drivers/alter/protocol.hpp"

namespace pal::skills {

/// Time between two requests of the robot controller's ALTER port, in s: a step is the way that the tool goes
/// in it.
inline constexpr double alter_period = std::chrono::duration<double>(runtime::drivers::alter::period).count();

/// Counts the steps that the tool was told to go. Lengths in mm, speeds in mm/s.
class Approach {
 public:
  /// At home; steps will be of `speed`, and lead no further away than `reach`.
  void start(double speed, double reach);

  /// The next step away from home; less than a whole one, or 0, where the reach ends.
  double step_forward();
  /// The next step towards home, negative; less than a whole one at the end, and 0 at home.
  double step_back();

  /// The tool is at its reach, and a force that is read now was measured there: see the constant below.
  bool felt_reach() const { return stood_ >= steps_until_felt; }
  /// The last step back was 0: the steps before it have been made, which a step that was only just given has
  /// not.
  bool at_home() const { return home_; }

 private:
  // A motion given at one request is made from the next to the one after it. The force read at the third is
  // the first that was measured when the tool had come to rest.
  static constexpr int steps_until_felt = 3;

  double step_ = 0;
  double reach_ = 0;
  double gone_ = 0;
  int stood_ = 0;  // steps of 0 at the reach
  bool home_ = false;
};

}  // namespace pal::skills
