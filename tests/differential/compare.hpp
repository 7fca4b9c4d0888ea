// Both analyses of a skill against each other, and against single runs that are made without them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace pal::test {

/// How far to go.
struct Effort {
  std::size_t classes = 500;  // of the exact analysis
  std::uint64_t walks = 20;   // runs a requirement
  int things = 800;           // that happen in each
  bool only_bounded = false;  // leave out what the compositional analysis has no bound of
};

/// What was compared, and what contradicted it.
struct Compared {
  std::size_t skills = 0;  // that have a meaning
  std::size_t requirements = 0;
  std::size_t exact = 0;      // bounds of the exact analysis
  std::size_t bounded = 0;    // of the compositional one
  std::size_t measured = 0;   // requirements of which some run has a value
  std::string contradiction;  // the first one, with the text and the run; "": none

  Compared& operator+=(const Compared& other);
};

/// Runs are drawn with `seed` (tests/support/runs/all_runs.hpp). A text without a meaning compares nothing.
Compared compare(const std::string& text, std::uint64_t seed, const Effort& effort);

}  // namespace pal::test
