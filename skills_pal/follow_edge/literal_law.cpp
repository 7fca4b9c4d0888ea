#include "skills_pal/follow_edge/literal_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pal::skills {

namespace {

// The thesis does not say when its alignment ends. Points are 0.6 mm apart at 200 mm, which is what y is
// known to, and the slope between two of them is known to 0.5 degrees.
constexpr double near_length = 1;   // mm
constexpr double near_slope = 1.5;  // deg
constexpr double in_degrees = 180 / std::numbers::pi;

}  // namespace

void LiteralLaw::start(const Limits& limits, double history, double standoff) {
  *this = {};
  limits_ = limits;
  history_ = history;
  standoff_ = standoff;
}

double LiteralLaw::limited_length(double length) const {
  return std::clamp(length, -limits_.translation, limits_.translation);
}
double LiteralLaw::limited_turn(double turn) const {
  return std::clamp(turn, -limits_.rotation, limits_.rotation);
}

void LiteralLaw::see(double y, double z, double slope, double gone) {
  if (!aligned_ && skip_) {
    skip_ = false;
    return;
  }
  const double off = z - standoff_;
  aligned_ = aligned_ ||
             (std::abs(y) <= near_length && std::abs(off) <= near_length && std::abs(slope) <= near_slope);
  skip_ = !aligned_;
  due_ = {};
  due_.y = limited_length(y);
  due_.z = limited_length(off);
  due_.rx = limited_turn(slope);
  if (!aligned_) return;
  remember(gone);
  const EdgeCorrection way = sum(gone);
  due_.ry = limited_turn(-std::atan(way.z / history_) * in_degrees);
  due_.rz = limited_turn(std::atan(way.y / history_) * in_degrees);
}

EdgeCorrection LiteralLaw::take() {
  const EdgeCorrection due = due_;
  due_ = {};
  return due;
}

void LiteralLaw::remember(double gone) {
  made_[count_ % room] = {gone, due_.y, due_.z};
  ++count_;
}

EdgeCorrection LiteralLaw::sum(double gone) const {
  EdgeCorrection way;
  for (std::size_t back = 1; back <= std::min(count_, room); ++back) {
    const Made& made = made_[(count_ - back) % room];
    if (gone - made.gone >= history_) break;
    way.y += made.y;
    way.z += made.z;
  }
  return way;
}

}  // namespace pal::skills
