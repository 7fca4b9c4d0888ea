// SM1 of both orders of touch, but for what only one has.
#pragma once

#include <memory>
#include <utility>

#include "skills_pal/modules/approach.hpp"
#include "skills_pal/modules/overload.hpp"
#include "skills_pal/modules/signature.hpp"

namespace pal::skills {

/// `approach` is shared with Retreat.
template <class Interface>
class Advance : public Interface {
  using Parameters = ArgumentOf<&Interface::start>;
  using Motion = ResultOf<&Interface::advance>;
  using Zforce = ArgumentOf<&Interface::decide_pc_force>;

 public:
  explicit Advance(std::shared_ptr<Approach> approach) : approach_(std::move(approach)) {}

  void start(const Parameters& parameters) override {
    refuse_overload(parameters.threshold, parameters.approach_speed, parameters.stiffness);
    approach_->start(parameters.approach_speed, parameters.reach);
    threshold_ = parameters.threshold;
  }

  Motion advance() override {
    Motion motion;
    motion.dz = approach_->step_forward();
    return motion;
  }

  bool decide_pc_force(const Zforce& force) override { return force.value >= threshold_; }
  bool decide_pc_reach() override { return approach_->felt_reach(); }

 private:
  std::shared_ptr<Approach> approach_;
  double threshold_ = 0;
};

}  // namespace pal::skills
