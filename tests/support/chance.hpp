// What random skills are drawn with.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace pal::test {

/// Random draws. The same seed gives the same draws.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}

  /// A number from 0 to n - 1.
  int operator()(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  int between(int low, int high) { return low + (*this)(high - low + 1); }

  /// One of `all`, of which there must be one.
  template <class T>
  const T& one_of(const std::vector<T>& all) {
    return all[static_cast<std::size_t>((*this)(static_cast<int>(all.size())))];
  }

  std::string one_of(const std::vector<std::string>& all) { return one_of<std::string>(all); }

  template <class T>
  void shuffle(std::vector<T>& all) {
    std::shuffle(all.begin(), all.end(), engine_);
  }

  /// A time from `low` to `high` as PAL has it, in milliseconds; a range, one time in this many.
  std::string interval(int low, int high, int one_range_in = 2) {
    const int best = between(low, high);
    const int worst = (*this)(one_range_in) != 0 ? best : between(best, high);
    return std::to_string(best) + (best == worst ? "" : " TO " + std::to_string(worst)) + " ms";
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace pal::test
