// CM1 of retreat.pal.
#pragma once

#include <memory>
#include <utility>

#include "skills_pal/modules/approach.hpp"
#include "skills_pal/modules/signature.hpp"

namespace pal::skills {

/// Back by the steps that the skill method went. It runs by Execute when the method's own motions have ended,
/// and so shares `approach` with it.
template <class Interface>
class Retreat final : public Interface {
  using Motion = ResultOf<&Interface::retreat>;

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
