// Range profiles of known shapes, as a sensor straight above them would give them.
#pragma once

#include <cmath>

#include "sim/report/profile_plot.hpp"

namespace pal::sim::test {

/// A pyramid of three steps of 10 mm on a table `standoff` away; a ray each half degree over 30 degrees. What
/// is steeper than the ray gives no point that is valid.
inline RangeProfile pyramid_profile(double standoff) {
  const auto height = [](double x) {
    return x < 10 && x > -10 ? 30.0 : x < 20 && x > -20 ? 20.0 : x < 30 && x > -30 ? 10.0 : 0.0;
  };
  RangeProfile profile{
      .title = std::to_string(static_cast<int>(standoff)) + " mm", .points = {}, .lines = {}, .marks = {}};
  for (int i = -60; i <= 60; ++i) {
    const double slope = std::tan(i * 0.25 * 3.14159265358979 / 180);
    double away = standoff - 40;
    while (away < standoff - height(slope * away)) away += 0.01;
    const bool edge = height(slope * away) != height(slope * away + (slope > 0 ? -2 : 2));
    profile.points.push_back({slope * away, away, !edge});
  }
  return profile;
}

}  // namespace pal::sim::test
