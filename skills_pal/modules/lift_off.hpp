// CM2 of lift_off.pal.
#pragma once

#include <stdexcept>

#include "skills_pal/modules/approach.hpp"
#include "skills_pal/modules/signature.hpp"

namespace pal::skills {

/// How far CM2 lifts the tool after it has felt nothing any more, how fast, and how far in all at the most.
inline constexpr double lift_distance = 5;  // mm
inline constexpr double lift_speed = 50;    // mm/s
inline constexpr double most_lift = 60;     // mm
// Moving shakes the tool, the more the faster: a force that is a contact, while it moves and when it stands.
inline constexpr double felt_moving = 2.5;    // N
inline constexpr double felt_standing = 0.5;  // N
inline constexpr double felt_aside = 1;       // N, along any axis: a tool beside a step leans on it

template <class Interface>
class LiftOff final : public Interface {
  using Motion = ResultOf<&Interface::lift>;
  using Parameters = ArgumentOf<&Interface::start>;
  using Zforce = ArgumentOf<&Interface::lift>;

 public:
  void start(const Parameters&) override {
    begin_last();
    lifted_ = 0;
    felt_ = true;
  }
  Motion lift(const Zforce& force) override {
    // A soft surface follows the tool for some way.
    felt_ = last_.felt_reach() ? force.value >= felt_standing || force.greatest >= felt_aside
                               : force.greatest >= felt_moving;
    if (felt_) begin_last();
    Motion motion;
    motion.dz = -last_.step_forward();
    lifted_ -= motion.dz;
    if (lifted_ > most_lift)
      throw std::runtime_error("the tool still presses 60 mm above where it met the stop force");
    return motion;
  }
  bool decide_pc_clear() override { return last_.felt_reach() && !felt_; }

 private:
  void begin_last() { last_.start(lift_speed, lift_distance); }

  Approach last_;      // the way after nothing is felt any more
  double lifted_ = 0;  // mm
  bool felt_ = true;
};

}  // namespace pal::skills
