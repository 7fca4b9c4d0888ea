// Which conditions the later steps of a thread will read, and what they will use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "pal/check/deadlock/automata.hpp"

namespace pal::check::deadlock {

/// Sets of numbers below a size, one a step; as wide as they must be.
class StepSets {
 public:
  StepSets(std::size_t steps, std::size_t size) : words_((size + 15) / 16), bits_(steps * words_, 0) {}

  bool has(std::size_t step, std::size_t index) const {
    return (bits_[step * words_ + index / 16] >> index % 16 & 1) != 0;
  }
  void add(std::size_t step, std::size_t index) {
    auto& word = bits_[step * words_ + index / 16];
    word = static_cast<char16_t>(word | 1U << index % 16);
  }
  /// Sixteen numbers at a time.
  char16_t word(std::size_t step, std::size_t word) const { return bits_[step * words_ + word]; }
  std::size_t words() const { return words_; }
  /// Adds to `step` what `from` has and `without` has not. Returns whether anything was added.
  bool join(std::size_t step, std::size_t from, const StepSets* without = nullptr);

 private:
  std::size_t words_;
  std::vector<char16_t> bits_;
};

/// By step: the conditions (by bit) whose value some run of the thread from there on reads before it sets it.
StepSets conditions_to_be_read(const Automata& automata);

/// By step: the conditions (by bit) that the next test from there on uses without reading them again.
StepSets latches_to_be_read(const Automata& automata);

/// Adds to every step what the steps that can follow it have. For a CONCURRENT these are the steps of the
/// blocks that it begins, and what follows it.
void close_over_future(const Automata& automata, StepSets& sets);

}  // namespace pal::check::deadlock
