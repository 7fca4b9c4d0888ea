// LS2 of surface_line.pal.
#pragma once

#include <cmath>

#include "skills_pal/modules/signature.hpp"
#include "skills_pal/sensing/line.hpp"

namespace pal::skills {

template <class Interface>
class SurfaceLineSensor final : public Interface {
  using Profile = ArgumentOf<&Interface::fit_surface>;
  using Surface = ResultOf<&Interface::fit_surface>;

 public:
  Surface fit_surface(const Profile& profile) override {
    Surface surface;
    surface.taken = profile.taken;
    const sensing::Points all = sensing::valid_points({profile.x, profile.z, profile.valid});
    if (all.count < least_points) return surface;
    const double noise = sensing::noise_of(all);
    const sensing::Points points = sensing::without_spikes(all, noise);
    const sensing::Line line = sensing::fit_line(points, {0, points.count}, noise);
    std::size_t on_line = 0;
    for (std::size_t i = 0; i < points.count; ++i)
      on_line += std::abs(points.z[i] - line.at(points.y[i])) <= thickness ? 1 : 0;
    surface.height = line.at(0);
    surface.lean = line.angle();
    surface.flat = static_cast<double>(on_line) >= least_share * static_cast<double>(all.count);
    return surface;
  }

 private:
  static constexpr std::size_t least_points = 50;
  static constexpr double thickness = 1;      // mm: points this far off do not belong to the surface
  static constexpr double least_share = 0.8;  // of the points must belong to it
};

}  // namespace pal::skills
