// Numbers from one unit to another, exactly.
#pragma once

#include <optional>
#include <string_view>

#include "pal/units/unit.hpp"

namespace pal::units {

/// The double nearest to `decimal` times `factor`; the product is computed exactly and rounded once: 0.06 m/s
/// are 60 mm/s. `decimal` is a decimal number ("-2.5", "1e-3"). Nothing if it is not, if the result is not a
/// finite double, or if the fraction's terms are above 10^18.
std::optional<double> converted(std::string_view decimal, const Ratio& factor);

}  // namespace pal::units
