// What makes the arm a machine and not a formula: encoders that count, gears with play.
#pragma once

#include <cstdint>

namespace pal::sim {

/// Which of the machine's imperfections are there. The defaults are the machine's.
struct MachineOptions {
  bool encoders = true;    // joint angles are whole counts of the encoders
  bool backlash = true;    // the gears have play
  std::uint64_t seed = 1;  // where the counts begin, and on which side the gears lie

  static MachineOptions exact() { return {.encoders = false, .backlash = false, .seed = 1}; }
};

}  // namespace pal::sim
