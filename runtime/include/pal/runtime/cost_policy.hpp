// How long things take in virtual time.
#pragma once

#include <cstdint>
#include <string>

#include "pal/runtime/wiring.hpp"

namespace pal::runtime {

enum class CostPolicy { worst, best, random };

/// Makes statements take longer than declared: those of module `module` in line `line`, from instant `from`
/// of the run on.
struct SlowStatement {
  std::string module;
  int line = 0;
  Time takes{};
  Time from{};
};

/// Draws times from their intervals: always the worst, always the best, or evenly spread, the same for the
/// same seed.
class CostDraw {
 public:
  CostDraw(CostPolicy policy, std::uint64_t seed) : policy_(policy), state_(seed) {}

  Time draw(const Interval& interval) {
    if (policy_ == CostPolicy::worst) return interval.worst;
    if (policy_ == CostPolicy::best || interval.best == interval.worst) return interval.best;
    return draw_within(interval);
  }

 private:
  Time draw_within(const Interval& interval);
  std::uint64_t next();

  CostPolicy policy_;
  std::uint64_t state_;
};

}  // namespace pal::runtime
