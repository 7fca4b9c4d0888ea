// Going towards a surface along the tool's Z axis, and back: what both orders of the touch skill do.
#pragma once

namespace pal::skills {

/// Counts the steps that the tool was told to go. Lengths in mm, speeds in mm/s.
class Approach {
 public:
  /// Time between two requests of the robot controller's ALTER port, in s: a step is the way that the tool
  /// goes in it.
  static constexpr double alter_period = 0.028;

  /// At home; steps will be of `speed`, and lead no further away than `reach`.
  void start(double speed, double reach);

  /// The next step away from home; less than a whole one, or 0, where the reach ends.
  double step_forward();
  /// The next step towards home, negative; less than a whole one at the end, and 0 at home.
  double step_back();

  bool at_reach() const { return gone_ >= reach_; }
  /// The last step back was 0: the steps before it have been made, which a step that was only just given has
  /// not.
  bool at_home() const { return home_; }

 private:
  double step_ = 0;
  double reach_ = 0;
  double gone_ = 0;
  bool home_ = false;
};

}  // namespace pal::skills
