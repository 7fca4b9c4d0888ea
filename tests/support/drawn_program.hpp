// Random programs for tests of the runtime: the same seed gives the same text.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "tests/support/any_skill.hpp"
#include "tests/support/mutant.hpp"
#include "tests/support/random_cell.hpp"

namespace pal::test {

/// A skill in a workcell; every third one is changed in a few places.
inline std::string drawn_program(std::uint64_t seed, int longest) {
  const std::string text = RandomCell(seed, longest, static_cast<int>(seed / 3 % 3)).text();
  if (seed % 3 != 0) return text;
  const auto accepts = [](const std::string& changed) { return any_skill(changed)->problem.has_value(); };
  return Mutant(seed, text, accepts).text(1 + static_cast<int>(seed / 3 % 5));
}

/// Deals out numbers by the seed: a Dealer of planned_skill.hpp.
inline auto dealer(std::uint64_t seed) {
  return [engine = std::mt19937_64(seed)](std::uint64_t n) mutable { return engine() % n; };
}

}  // namespace pal::test
