// What a number of a payload may be. Payloads are doubles: an INTEGER is a whole number up to 2^53, a REAL is
// finite, a BOOLEAN is 0 or 1.
#pragma once

#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace pal::runtime {

/// The greatest whole number that a payload carries without loss; its negative is the least.
inline constexpr std::int64_t greatest_whole = std::int64_t{1} << 53;

/// Throws std::out_of_range for a number that is not such: a fraction, NaN, more than 2^53.
inline std::int64_t whole(double number) {
  if (!(number >= -static_cast<double>(greatest_whole) && number <= static_cast<double>(greatest_whole)))
    throw std::out_of_range("a message's INTEGER field is not a number from -2^53 to 2^53");
  const auto result = static_cast<std::int64_t>(number);
  if (static_cast<double>(result) != number)
    throw std::out_of_range("a message's INTEGER field is not a whole number");
  return result;
}

/// Throws std::out_of_range beyond 2^53.
inline double from_whole(std::int64_t value) {
  if (value < -greatest_whole || value > greatest_whole)
    throw std::out_of_range("a message's INTEGER field is beyond 2^53, which a message cannot carry");
  return static_cast<double>(value);
}

/// Throws std::out_of_range for an infinity, or for what is no number.
inline double finite(double number) {
  if (!std::isfinite(number)) throw std::out_of_range("a message's REAL field is not a finite number");
  return number;
}

/// Throws std::out_of_range for what is neither 0 nor 1.
inline bool truth(double number) {
  if (number != 0 && number != 1) throw std::out_of_range("a message's BOOLEAN field is neither 0 nor 1");
  return number == 1;
}

}  // namespace pal::runtime
