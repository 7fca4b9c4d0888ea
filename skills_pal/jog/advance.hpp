// How far each axis goes in the next cycle of a jog.
#pragma once

#include <array>

namespace pal::skills {

/// Six axes; three lengths in mm and three angles in degrees, or six angles.
using Axes = std::array<double, 6>;

/// Speeds up within three cycles. Stops at once: whoever stops a jog sends no more motions. A step slows down
/// before its end, and ends where it should to the last digit.
class JogAdvance {
 public:
  /// `most`: how far each axis may go in a cycle. `step`: how far it goes in all; all of them 0: there is no
  /// end.
  void start(const Axes& most, const Axes& step);

  /// The way of the next cycle; `wanted`: how fast each axis is to go, from -1 to 1 of the most. The direction
  /// of a step is that of the first order that has one.
  Axes next(const Axes& wanted);

  /// The step is made.
  bool there() const { return there_; }

 private:
  Axes along_step(const Axes& wanted);

  Axes most_{}, step_{};
  Axes speed_{};      // a cycle
  bool steps_ = false;
  Axes whole_{};      // way of the step; all 0: it has no direction yet
  double gone_ = 0;   // part of it, 0 to 1
  double rate_ = 0;   // part of it in a cycle
  bool there_ = false;
};

}  // namespace pal::skills
