// The imperfections of the real arm: encoders that count, gears with play.
#pragma once

#include <cstdint>

namespace pal::sim {

/// The imperfections that are switched on. The defaults are the machine's.
struct MachineOptions {
  bool encoders = true;    // joint angles are whole counts of the encoders
  bool backlash = true;    // the gears have play
  std::uint64_t seed = 1;  // where the counts begin, and on which side the gears lie

  static MachineOptions exact() { return {.encoders = false, .backlash = false, .seed = 1}; }
};

}  // namespace pal::sim
