// How much memory the program uses.
#pragma once

#include <cstddef>

namespace pal::program {

/// The most resident memory in bytes since the last call, or since the start. If the system cannot restart
/// the count (/proc/self/clear_refs), it is always since the start; 0 if it is not known.
std::size_t peak_memory();

}  // namespace pal::program
