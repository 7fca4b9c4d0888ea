// How much memory the program uses.
#pragma once

#include <cstddef>

namespace pal::program {

/// The most resident memory in bytes since the last call, or since the start. If the system cannot restart
/// the count (/proc/self/clear_refs), it is always since the start; 0 if it is not known.
std::size_t peak_memory();

/// The bytes that this program can have: the least of what is free on the machine, what its control groups
/// allow (cgroups(7)), and its own limit (RLIMIT_AS, `ulimit -v`).
std::size_t memory_there_is();

/// Whether the program takes more than so many bytes now. Memory that it has given back, and its allocator
/// keeps, is returned to the system before that is said. For any thread; it is looked at every few
/// milliseconds only.
bool takes_more(std::size_t bytes);

/// Returns memory to the system that was freed, and that the allocator keeps.
void give_back_memory();

/// Likewise, if that is more than `bytes`. For any thread, and as often as one likes.
void give_back_memory_beyond(std::size_t bytes);

}  // namespace pal::program
