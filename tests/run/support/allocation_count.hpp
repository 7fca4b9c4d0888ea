// Counts what is allocated while it is told to.
#pragma once

#include <cstddef>

namespace pal::test {

/// From now on, allocations count, or count no more. One thread only.
void count_allocations(bool on);

/// Counted since the last reset.
std::size_t counted_allocations();
void reset_allocations();

}  // namespace pal::test
