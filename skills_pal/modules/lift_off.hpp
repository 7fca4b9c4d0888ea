// CM2 of lift_off.pal.
#pragma once

#include "skills_pal/modules/approach.hpp"
#include "skills_pal/modules/signature.hpp"

namespace pal::skills {

/// How far and how fast CM2 lifts the tool.
inline constexpr double lift_distance = 5;  // mm
inline constexpr double lift_speed = 50;    // mm/s

template <class Interface>
class LiftOff final : public Interface {
  using Motion = ResultOf<&Interface::lift>;
  using Parameters = ArgumentOf<&Interface::start>;

 public:
  void start(const Parameters&) override { lifted_.start(lift_speed, lift_distance); }
  Motion lift() override {
    Motion motion;
    motion.dz = -lifted_.step_forward();
    return motion;
  }
  bool decide_pc_clear() override { return lifted_.felt_reach(); }

 private:
  Approach lifted_;
};

}  // namespace pal::skills
