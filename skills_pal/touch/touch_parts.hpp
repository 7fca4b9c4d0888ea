// The activities that both orders of the touch skill share. Each order has message types of its own,
// generated from the same PAL: the parts are templates over them.
#pragma once

#include <memory>
#include <utility>

#include "skills_pal/touch/approach.hpp"

namespace pal::skills {

/// LS1. The sensor feels a negative Fz when the tool presses against something in front of it; Zforce is how
/// hard it presses, in N.
template <class Interface, class Wrench, class Zforce>
class ZForceSensor : public Interface {
 public:
  Zforce extract_z(const Wrench& wrench) override {
    Zforce force;
    force.value = -wrench.fz;
    return force;
  }
};

/// MC1: what a skill asks for goes to the ALTER port as it is; without a motion in time the tool stays where
/// it is.
template <class Interface, class Motion, class Correction>
class AlterPort : public Interface {
 public:
  Correction obey(const Motion& motion) override { return Correction::from_fields(motion.fields()); }
  Correction hold() override { return {}; }
};

/// SM1 without what only one order has. `approach` is shared with Retreat.
template <class Interface, class Parameters, class Motion, class Zforce>
class Advance : public Interface {
 public:
  explicit Advance(std::shared_ptr<Approach> approach) : approach_(std::move(approach)) {}

  void start(const Parameters& parameters) override {
    approach_->start(parameters.approach_speed, parameters.reach);
    threshold_ = parameters.threshold;
  }

  Motion advance() override {
    Motion motion;
    motion.dz = approach_->step_forward();
    return motion;
  }

  bool decide_pc_force(const Zforce& force) override { return force.value >= threshold_; }
  bool decide_pc_reach() override { return approach_->at_reach(); }

 private:
  std::shared_ptr<Approach> approach_;
  double threshold_ = 0;
};

/// CM1: back by the steps that Advance went. It runs by Execute when SM1's own motions have ended.
template <class Interface, class Motion>
class Retreat : public Interface {
 public:
  explicit Retreat(std::shared_ptr<Approach> approach) : approach_(std::move(approach)) {}

  Motion retreat() override {
    Motion motion;
    motion.dz = approach_->step_back();
    return motion;
  }

  bool decide_pc_home() override { return approach_->at_home(); }

 private:
  std::shared_ptr<Approach> approach_;
};

}  // namespace pal::skills
