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
// While the tool stands, the arm comes to rest where its encoders have whole counts: heights that are up to
// 0.1 mm apart at the tool. A small motion is answered by a jump or not at all. So near the target one motion
// is made at a time, a try, and its effect is observed. A force that is good enough is left alone.
constexpr double way_standing = 0.2;
constexpr double near = 0.8;          // N: greater errors are taken away without looking
constexpr double good = 0.04;         // N: a smaller error is good enough, at first
constexpr double hold = 0.09;         // N: and is left alone until it is greater than this
constexpr int standing_cycles = 107;  // 3 s: what still moves then, creeps, and a try would shake it
constexpr double modesty = 0.07;      // each try that leads over the target raises `good` by this part of it
constexpr int blind_cycles = 4;       // after a motion: it is on its way, and the arm comes to rest
constexpr int look_cycles = 8;        // whose forces are averaged
// Parts of the way to the target that a try goes. They differ, as equal ones lead to and fro between two
// places.
constexpr double least_part = 0.3;
constexpr double most_part = 0.9;
// A try that stays on its side of the target makes the next one longer: the surface is softer than assumed.
constexpr double longer = 1.3;
constexpr double longest = 3;
// After a try that led over the target the tool leans by up to this much, deg. The wrist is 151 mm from the
// tip, so it then rests on other counts of the joints. Their heights lie between the ones that were tried.
constexpr double most_lean = 0.03;
constexpr double golden = 0.6180339887;  // its multiples, without their whole parts, are spread evenly

constexpr double contact = 0.3;        // N: less is noise
constexpr double certain = 1.0;        // N: the tool is in contact without doubt
constexpr double least_motion = 0.05;  // mm: smaller motions tell nothing of the stiffness
constexpr double learning = 0.3;
constexpr double trust = 3;       // in the stiffness that was given, as a factor
constexpr double steepest = 0.6;  // mm a cycle

}  // namespace

void ForceRegulator::start(double target, double stiffness, double most, double drift) {
  *this = {};
  target_ = target;
  stiffness_ = given_stiffness_ = stiffness;
  most_ = most;
  drift_ = std::max(drift, hold);
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

double ForceRegulator::standing(double force, double missing) {
  held_ = holds_ ? held_ + 1 : 0;
  if (std::abs(missing) * stiffness_ > near) {
    look_again();
    holds_ = false;
    return way_standing * missing;
  }
  if (++looked_ <= blind_cycles) return 0;
  seen_ += (target_ - force) / look_cycles;
  if (looked_ < blind_cycles + look_cycles) return 0;
  const double error = seen_;
  look_again();
  const double enough = good * (1 + modesty * leaps_);
  const double leave = held_ < standing_cycles ? hold : drift_;
  holds_ = std::abs(error) <= (holds_ ? std::max(leave, enough) : enough);
  if (!holds_) return attempt(error);
  looked_ = blind_cycles;  // nothing is on its way
  return 0;
}

double ForceRegulator::attempt(double error) {
  ++tries_;
  if (error * tried_ < 0) {
    ++leaps_;
    reach_ = 1;
    const double lean = most_lean * (2 * std::fmod(golden * leaps_, 1.0) - 1);
    turn_ = lean - leaning_;
    leaning_ = lean;
  } else if (tried_ != 0) {
    reach_ = std::min(longer * reach_, longest);
  }
  tried_ = error;
  const double part = least_part + (most_part - least_part) * std::fmod(golden * tries_, 1.0);
  return part * reach_ * error / stiffness_;
}

void ForceRegulator::look_again() {
  looked_ = 0;
  seen_ = 0;
}

double ForceRegulator::next(double force, bool sliding) {
  if (!sliding) learn(force);
  observe(force, sliding);
  turn_ = 0;
  const double soon = depth_ + given_ + rise_;
  const double missing = target_ / stiffness_ - soon;
  const double motion =
      std::clamp(sliding ? way_sliding * missing - rise_ : standing(force, missing), -most_, most_);
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
