// MC1 of alter.pal.
#pragma once

#include <atomic>
#include <memory>
#include <stdexcept>
#include <utility>

#include "skills_pal/modules/signature.hpp"

namespace pal::skills {

/// What becomes of a request of ALTER for which the skill has no motion in time. Its motion, which comes too
/// late, is dropped.
enum class Late {
  hold,   // the tool stays where it is for a cycle: for skills that look again where it is
  refuse  // likewise before the first motion; later the skill ends with its error completion: for skills that
          // count their steps, whose motions are proved to be in time
};

/// How many motions MC1 has passed on. A skill method that is asked for the next motion learns from it
/// whether its last one was dropped. MC1 may have another processor than the method.
using MotionCount = std::atomic<int>;

/// What a skill asks for goes to the ALTER port as it is.
template <class Interface>
class AlterController final : public Interface {
  using Parameters = ArgumentOf<&Interface::start>;
  using Motion = ArgumentOf<&Interface::obey>;
  using Correction = ResultOf<&Interface::obey>;

 public:
  explicit AlterController(Late late, std::shared_ptr<MotionCount> obeyed = std::make_shared<MotionCount>(0))
      : late_(late), obeyed_(std::move(obeyed)) {}

  void start(const Parameters&) override { obeyed_->store(0); }

  Correction obey(const Motion& motion) override {
    obeyed_->fetch_add(1);
    return Correction::from_fields(motion.fields());
  }
  Correction hold() override {
    if (late_ == Late::refuse && obeyed_->load() > 0)
      throw std::runtime_error(
          "no motion came within 4 ms of ALTER's request: a step is missing, and the tool is not where the "
          "skill counts it to be");
    return {};
  }

 private:
  Late late_;
  std::shared_ptr<MotionCount> obeyed_;
};

}  // namespace pal::skills
