// How much memory the program takes.
#pragma once

#include <cstddef>

namespace pal::driver {

/// The most resident memory in bytes since the last call, or since the start; where the system does not let
/// it be counted anew (/proc/self/clear_refs) always since the start; 0 where it cannot be told.
std::size_t peak_memory();

}  // namespace pal::driver
