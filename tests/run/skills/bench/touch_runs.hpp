// Runs of touch: how much harder than its threshold the tool presses.
#pragma once

#include <algorithm>

#include "sim/scene.hpp"
#include "tests/run/skills/support/proved_bounds.hpp"

namespace pal::test {

inline constexpr double touch_threshold = 5;  // N

struct Range {
  double least = 1e9, greatest = -1e9;
  void add(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
};

/// N beyond the threshold.
struct Overshoot {
  Range peak;         // of the contact force
  Range felt;         // its peak by the sensor, without noise and delay
  Range resting;      // of the contact force at rest
  bool ended = true;  // all with completion 0
};

/// At 25 phases of ALTER, 25 heights of the start, and seeds 1 to 25. `speed` in mm/s. `bounds`, if given,
/// observes the runs.
Overshoot touch_runs(const sim::Scene& scene, double speed, ProvedBounds* bounds = nullptr);

}  // namespace pal::test
