// A surface like a spring, without an arm: what the regulator of press and rub makes of it.
#pragma once

#include <cmath>
#include <deque>
#include <numbers>

#include "skills_pal/modules/force_regulator.hpp"

namespace pal::test {

struct SpringSurface {
  double stiffness = 10;  // N/mm
  double slope = 0;       // mm a cycle, once the tool slides
  double waves = 0;       // the same, as the greatest slope of waves of `cycles_a_wave`
  double cycles_a_wave = 128;
};

struct ForceErrors {
  double greatest = 0;  // N
  double rms = 0;       // N
};

/// Of the force, once the tool has slid for 40 cycles; the target is 5 N. The force that is known at a
/// request is `cycles_old` cycles old; a motion is made from the next request to the one after it. `noise`
/// gives what is added to a force that is read, N.
template <class Noise>
ForceErrors regulated_errors(const SpringSurface& surface, double assumed, int cycles_old, Noise noise) {
  constexpr double target = 5;  // N
  constexpr int cycles = 400, landed = 80, slid = 40;
  skills::ForceRegulator regulator;
  regulator.start(target, assumed, 0.8);
  double depth = 0, given = 0;
  ForceErrors errors;
  std::deque<double> forces(static_cast<std::size_t>(cycles_old) + 1, 0.0);
  for (int i = 0; i < cycles; ++i) {
    const bool sliding = i >= landed;
    const double force = surface.stiffness * std::max(0.0, depth);
    forces.push_back(force + noise());
    forces.pop_front();
    if (i >= landed + slid) {
      errors.greatest = std::max(errors.greatest, std::abs(force - target));
      errors.rms += (force - target) * (force - target) / (cycles - landed - slid);
    }
    const double motion = regulator.next(forces.front(), sliding);
    const double rise =
        surface.slope + surface.waves * std::cos(2 * std::numbers::pi * i / surface.cycles_a_wave);
    depth += given + (sliding ? rise : 0);
    given = motion;
  }
  errors.rms = std::sqrt(errors.rms);
  return errors;
}

}  // namespace pal::test
