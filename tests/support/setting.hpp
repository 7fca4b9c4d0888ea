// How long random tests go on.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <vector>

namespace pal::test {

/// A number from the environment (PAL_SEED, PAL_ROUNDS, …), which makes a run longer, or another one.
inline std::uint64_t setting(const char* name, std::uint64_t usual) {
  const char* value = std::getenv(name);
  return value == nullptr ? usual : std::strtoull(value, nullptr, 10);
}

/// A part of a campaign of many seeds, which several tests run: every `of`-th seed from the `number`-th on.
struct Part {
  std::uint64_t number = 1;
  std::uint64_t of = 1;
};

/// The seeds of a part. The whole campaign has PAL_ROUNDS seeds, or `rounds`, from PAL_SEED on, or `first`.
inline std::vector<std::uint64_t> seeds(std::uint64_t first, std::uint64_t rounds, Part part = {}) {
  const std::uint64_t begin = setting("PAL_SEED", first);
  const std::uint64_t end = begin + setting("PAL_ROUNDS", rounds);
  std::vector<std::uint64_t> chosen;
  for (std::uint64_t seed = begin + part.number - 1; seed < end; seed += part.of) chosen.push_back(seed);
  return chosen;
}

}  // namespace pal::test
