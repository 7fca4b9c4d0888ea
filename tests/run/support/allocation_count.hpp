// Counts what is allocated while it is told to.
#pragma once

#include <cstddef>

namespace pal::test {

/// From now on, allocations of all threads count, or count no more.
void count_allocations(bool on);

/// Counted since the last reset.
std::size_t counted_allocations();
void reset_allocations();

}  // namespace pal::test
