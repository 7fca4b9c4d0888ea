#include "analyzer/load/fraction.hpp"

namespace pal::analyzer {
namespace {

__extension__ using Wide = __int128;

}  // namespace

bool greater(const Fraction& a, const Fraction& b) {
  return static_cast<Wide>(a.work) * b.time > static_cast<Wide>(b.work) * a.time;
}

Nanoseconds per_second(const Fraction& fraction) {
  const Wide scaled = static_cast<Wide>(fraction.work) * 1'000'000'000;
  return static_cast<Nanoseconds>((scaled + fraction.time - 1) / fraction.time);
}

}  // namespace pal::analyzer
