// Time in PAL is a whole number of nanoseconds; nothing in an analysis is a floating-point number.
#pragma once

#include <chrono>
#include <compare>

namespace pal {

/// A length of time, or an instant counted from the start of the skill.
using Duration = std::chrono::nanoseconds;

/// The execution time of an activity, the latency of a message, …: between `best` and `worst`, both attained.
/// Contract: 0 <= best <= worst.
struct Interval {
  Duration best{};
  Duration worst{};

  friend auto operator<=>(const Interval&, const Interval&) = default;
};

}  // namespace pal
