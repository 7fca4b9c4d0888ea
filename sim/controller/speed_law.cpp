#include "sim/controller/speed_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pal::sim {

SpeedLaw::State unit_ramp(double x) {
  constexpr double turn = 2 * std::numbers::pi;
  return {x * x / 2 + (std::cos(turn * x) - 1) / (turn * turn), x - std::sin(turn * x) / turn,
          1 - std::cos(turn * x)};
}

SpeedLaw::SpeedLaw(double length, double speed, double acceleration)
    : length_(length), speed_(std::min(speed, std::sqrt(length * acceleration / 2))) {
  if (speed_ <= 0) return;
  ramp_ = 2 * speed_ / acceleration;                 // the greatest acceleration is twice the mean one
  cruise_ = std::max(0.0, length / speed_ - ramp_);  // a ramp covers half of what the cruise would
}

SpeedLaw::State SpeedLaw::at(double seconds) const {
  if (seconds <= 0 || speed_ <= 0) return {seconds <= 0 ? 0 : length_, 0, 0};
  if (seconds >= duration()) return {length_, 0, 0};
  const bool leaving = seconds > ramp_ + cruise_;
  if (!leaving && seconds >= ramp_) return {speed_ * (seconds - ramp_ / 2), speed_, 0};
  const State part = unit_ramp((leaving ? duration() - seconds : seconds) / ramp_);
  const double way = speed_ * ramp_ * part.way;
  const double gain = speed_ / ramp_ * part.acceleration;
  return {leaving ? length_ - way : way, speed_ * part.speed, leaving ? -gain : gain};
}

}  // namespace pal::sim
