// Whole skills, mutated line by line towards new code of the analyzer. The compositional bounds are compared
// with the exact ones, and with runs that are made without either.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

#include "tests/differential/compare.hpp"
#include "tests/support/kinds.hpp"
#include "tests/support/mutant.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr pal::test::Effort effort{300, 6, 400, true};
  const pal::test::Compared compared = pal::test::compare(std::string(data, data + size), size, effort);
  if (compared.contradiction.empty()) return 0;
  std::cerr << compared.contradiction;
  std::abort();
}

/// Mostly a few changes to the skill that is there, now and then one that is new.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
  std::minstd_rand draw(seed);
  const bool anew = draw() % 16 == 0;
  const int steps = 1 + static_cast<int>(draw() % 4);
  const std::string old(data, data + size);
  const std::string base = anew ? pal::test::skill_of_any_kind(seed) : old;
  const std::string text = pal::test::Mutant(seed, base, pal::test::has_meaning).text(steps);
  if (text.size() > max_size) return size;
  std::copy(text.begin(), text.end(), data);
  return text.size();
}
