// How long things take in virtual time.
#pragma once

#include <cstdint>

#include "pal/runtime/wiring.hpp"

namespace pal::runtime {

enum class CostPolicy { worst, best, random };

/// Draws times from their intervals: always the worst, always the best, or evenly spread, the same for the
/// same seed.
class CostDraw {
 public:
  CostDraw(CostPolicy policy, std::uint64_t seed) : policy_(policy), state_(seed) {}

  Time draw(const Interval& interval);

 private:
  std::uint64_t next();

  CostPolicy policy_;
  std::uint64_t state_;
};

}  // namespace pal::runtime
