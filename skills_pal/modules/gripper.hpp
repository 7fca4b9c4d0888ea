// LS3 of gripper.pal.
#pragma once

#include "skills_pal/modules/signature.hpp"

namespace pal::skills {

template <class Interface>
class GripSensor final : public Interface {
  using State = ArgumentOf<&Interface::feel>;
  using Grip = ResultOf<&Interface::feel>;

 public:
  Grip feel(const State& state) override {
    Grip grip;
    grip.width = state.width;
    grip.holding = state.holding;
    return grip;
  }
};

}  // namespace pal::skills
