// Sets of threads of a skill.
#pragma once

#include <bitset>
#include <cstddef>

namespace pal::check::deadlock {

/// Skills with more threads are not searched.
inline constexpr std::size_t most_threads = 256;

using Threads = std::bitset<most_threads>;

}  // namespace pal::check::deadlock
