// The imperfections of the real arm and its sensors: encoders that count, gears with play, noise.
#pragma once

#include <cstdint>

namespace pal::sim {

/// The imperfections that are switched on. The defaults are the machine's.
struct MachineOptions {
  bool encoders = true;    // joint angles are whole counts of the encoders
  bool backlash = true;    // the gears have play
  bool noise = true;       // the force-torque sensor and the range finder err
  std::uint64_t seed = 1;  // where the counts begin, and on which side the gears lie

  /// An exact arm; its sensors err as they do.
  static MachineOptions exact() { return {.encoders = false, .backlash = false}; }
};

}  // namespace pal::sim
