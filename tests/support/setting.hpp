// How long tests by chance go on.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace pal::test {

/// A number from the environment (PAL_SEED, PAL_ROUNDS, …), which makes a run longer, or another one.
inline std::uint64_t setting(const char* name, std::uint64_t usual) {
  const char* value = std::getenv(name);
  return value == nullptr ? usual : std::strtoull(value, nullptr, 10);
}

}  // namespace pal::test
