// LS2 of nearest_point.pal.
#pragma once

#include "skills_pal/modules/signature.hpp"
#include "skills_pal/sensing/nearest_point.hpp"

namespace pal::skills {

template <class Interface>
class NearestPointSensor final : public Interface {
  using Profile = ArgumentOf<&Interface::find_nearest>;
  using Distance = ResultOf<&Interface::find_nearest>;

 public:
  Distance find_nearest(const Profile& profile) override {
    Distance distance;
    distance.taken = profile.taken;
    const auto nearest = sensing::find_nearest_point({profile.x, profile.z, profile.valid});
    distance.seen = nearest.has_value();
    if (nearest) distance.value = nearest->z;
    return distance;
  }
};

}  // namespace pal::skills
