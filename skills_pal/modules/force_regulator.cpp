#include "skills_pal/modules/force_regulator.hpp"

#include <algorithm>
#include <cmath>

namespace pal::skills {

namespace {

// Gains of the model's correction: the force's noise (0.05 N) against changes of slope.
constexpr double depth_gain = 0.7;
constexpr double rise_gain = 0.25;
// Part of the missing way that is gone in a cycle.
constexpr double way_sliding = 0.5;
// The joints stick while the tool stands: a small motion is answered late, by a jump of up to 0.05 mm, and
// the harder the faster it was. So what is left of an error is taken away slowly, and very little is left
// alone.
constexpr double way_standing = 0.2;
constexpr double quiet = 0.08;  // N
constexpr double near = 0.8;    // N: errors below this are taken away by no more than
constexpr double creep = 0.1;  // N a cycle

constexpr double contact = 0.3;        // N: less is noise
constexpr double certain = 1.0;        // N: the tool is in contact without doubt
constexpr double least_motion = 0.05;  // mm: smaller motions tell nothing of the stiffness
constexpr double learning = 0.3;
constexpr double trust = 3;       // in the stiffness that was given, as a factor
constexpr double steepest = 0.6;  // mm a cycle

}  // namespace

void ForceRegulator::start(double target, double stiffness, double most) {
  *this = {};
  target_ = target;
  stiffness_ = given_stiffness_ = stiffness;
  most_ = most;
}

void ForceRegulator::learn(double force) {
  if (force_ < certain || force < certain || std::abs(before_) < least_motion) return;
  stiffness_ += learning * ((force - force_) - stiffness_ * before_) / before_;
  stiffness_ = std::clamp(stiffness_, given_stiffness_ / trust, given_stiffness_ * trust);
}

void ForceRegulator::observe(double force, bool sliding) {
  const double expected = depth_ + before_ + (sliding ? rise_ : 0);
  if (force <= contact && expected <= 0) {  // in the air: how far away is not known
    depth_ = std::min(expected, 0.0);
    return;
  }
  double surprise = force / stiffness_ - expected;
  if (force <= contact) surprise = std::min(surprise, 0.0);
  depth_ = expected + depth_gain * surprise;
  if (sliding) rise_ = std::clamp(rise_ + rise_gain * surprise, -steepest, steepest);
}

double ForceRegulator::standing(double missing) const {
  const double error = std::abs(missing) * stiffness_;
  if (error < quiet) return 0;
  if (error > near) return way_standing * missing;
  return std::clamp(way_standing * missing, -creep / stiffness_, creep / stiffness_);
}

double ForceRegulator::next(double force, bool sliding) {
  if (!sliding) learn(force);
  observe(force, sliding);
  const double soon = depth_ + given_ + rise_;
  const double missing = target_ / stiffness_ - soon;
  const double motion =
      std::clamp(sliding ? way_sliding * missing - rise_ : standing(missing), -most_, most_);
  remember(force, motion);
  return motion;
}

void ForceRegulator::follow(double force, double motion) {
  learn(force);
  observe(force, false);
  remember(force, motion);
}

void ForceRegulator::remember(double force, double motion) {
  before_ = given_;
  given_ = motion;
  force_ = force;
  gone_ += motion;
}

}  // namespace pal::skills
