#include "pal/runtime/cost_policy.hpp"

namespace pal::runtime {

// SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014). It gives the
// same numbers on every machine. The distributions of the standard library do not promise this.
std::uint64_t CostDraw::next() {
  state_ += 0x9e3779b97f4a7c15U;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

Time CostDraw::draw_within(const Interval& interval) {
  const auto choices = static_cast<std::uint64_t>((interval.worst - interval.best).count()) + 1;
  return interval.best + Time(static_cast<Time::rep>(next() % choices));
}

}  // namespace pal::runtime
