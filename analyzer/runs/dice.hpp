// Choices that are drawn by seed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "analyzer/machine/machine.hpp"

namespace pal::analyzer {

/// Draws, and remembers what it drew for the firing at hand.
class Dice final : public Choices {
 public:
  /// `seldom`: as in SimulationOptions.
  Dice(std::uint64_t seed, std::uint64_t seldom) : engine_(seed), seldom_(seldom) {}

  int pick(int n) override {
    const bool first = seldom_ > 0 && below(seldom_) > 0;
    const int picked = first ? 0 : drawn(std::min(n, most_picks));
    picks_.push_back(static_cast<std::uint8_t>(picked));
    return picked;
  }
  int drawn(int n) { return static_cast<int>(below(static_cast<std::uint64_t>(n))); }
  std::uint64_t below(std::uint64_t n) { return engine_() % n; }
  void draw_seldom(std::uint64_t seldom) { seldom_ = seldom; }

  std::vector<std::uint8_t> take_picks() { return std::exchange(picks_, {}); }

 private:
  /// Of more only the first are drawn from: a script holds small numbers.
  static constexpr int most_picks = 255;

  std::mt19937_64 engine_;
  std::uint64_t seldom_;
  std::vector<std::uint8_t> picks_;
};

}  // namespace pal::analyzer
