// Physical units: what they measure, and their exact ratios.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pal::units {

/// A fraction in lowest terms, with a denominator above 0.
struct Ratio {
  std::int64_t over = 1;
  std::int64_t under = 1;

  friend bool operator==(const Ratio&, const Ratio&) = default;
};

/// Powers of the base units: m, kg, s, A, K, rad, count. Angles are a dimension here, because deg and rad are
/// not plain numbers.
using Dimension = std::array<int, 7>;

/// A unit as a multiple of a product of base units. deg is pi/180 rad, so there is a power of pi beside the
/// ratio.
struct Unit {
  Dimension dimension{};
  Ratio scale;
  int power_of_pi = 0;
  bool from_zero = true;  // false: degC, whose zero is not the base unit's, alone or in no product

  friend bool operator==(const Unit&, const Unit&) = default;
};

/// A product or quotient of known units with small whole powers, spelt without spaces: "mm", "N*m", "deg/s",
/// "m/s^2"; "%". Nothing for any other spelling, or if the scale is too great to be exact.
std::optional<Unit> parse_unit(std::string_view spelling);

/// How many `to` are one `from`. Nothing if they differ in dimension, if the number is not a fraction (deg in
/// rad), or if their zeros differ.
std::optional<Ratio> factor(const Unit& from, const Unit& to);

/// The known units, for a message.
std::string known_units();

}  // namespace pal::units
