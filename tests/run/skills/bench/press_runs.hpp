// Runs of press: how near the force was to the one asked for while the skill held it.
#pragma once

#include <string>

#include "tests/run/skills/support/proved_bounds.hpp"

namespace pal::test {

inline constexpr double press_force = 5;  // N
inline constexpr double press_time = 2;   // s

struct Held {
  double greatest = 0;   // N off, at most
  double rms = 1e9;      // N off
  double worst_rms = 0;  // N off, of one run
  double peak = 0;       // N, of the whole runs
  bool ended = true;     // all with completion 0
};

/// With seeds 1 to 5; `lines` are added to the scene. `bounds`, if given, observes the runs.
Held press_runs(const std::string& plate, const std::string& lines = {}, ProvedBounds* bounds = nullptr);

}  // namespace pal::test
