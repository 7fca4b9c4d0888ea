// The speed of a motion over time.
#pragma once

namespace pal::sim {

/// The distance along a path as a function of time. First the acceleration rises and falls as 1 - cos. Then
/// comes a cruise at constant speed, and then the same backwards. Speed and acceleration have no steps, so
/// the servos can follow. Any unit of length.
class SpeedLaw {
 public:
  struct State {
    double way = 0;
    double speed = 0;
    double acceleration = 0;
  };

  /// Contract: length >= 0, speed > 0, acceleration > 0. `acceleration` is the greatest. If the way is too
  /// short for the speed, the speed is lower.
  SpeedLaw(double length, double speed, double acceleration);

  double duration() const { return 2 * ramp_ + cruise_; }  // s
  double top_speed() const { return speed_; }
  /// How long gathering speed takes, s.
  double ramp() const { return ramp_; }
  /// `seconds` from the beginning; before it and after the end the motion stands still.
  State at(double seconds) const;

 private:
  double length_;
  double speed_;
  double ramp_ = 0;
  double cruise_ = 0;
};

/// The ramp of SpeedLaw by itself: from speed 0 to 1 within time 1. Contract: 0 <= x <= 1.
SpeedLaw::State unit_ramp(double x);

}  // namespace pal::sim
