// LS1 of z_force.pal.
#pragma once

#include <algorithm>
#include <cmath>

#include "skills_pal/modules/signature.hpp"

namespace pal::skills {

/// The sensor feels a negative Fz when the tool presses against something in front of it; Zforce is how hard
/// it presses, in N.
template <class Interface>
class ZForceSensor final : public Interface {
  using Wrench = ArgumentOf<&Interface::extract_z>;
  using Zforce = ResultOf<&Interface::extract_z>;

 public:
  Zforce extract_z(const Wrench& wrench) override {
    Zforce force;
    force.value = -wrench.fz;
    force.greatest = std::max({std::abs(wrench.fx), std::abs(wrench.fy), std::abs(wrench.fz)});
    return force;
  }
};

}  // namespace pal::skills
