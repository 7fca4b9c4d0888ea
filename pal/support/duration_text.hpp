// Lengths of time as PAL writes them: 28 ms, 0.1 TO 0.2 ms.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "pal/support/time.hpp"

namespace pal {

enum class DurationError { no_number, no_unit, not_whole, overflow };

/// `number` (as the grammar's NUMBER: "0.1", "1e3", "-2") of `unit` ("ns", "us", "ms", "s", "min"), exactly.
/// Errors: not a number, not a unit of time, not a whole number of nanoseconds, more than Duration holds.
std::variant<Duration, DurationError> parse_duration(std::string_view number, std::string_view unit);

/// `percent` (as the number of parse_duration) of a second, exactly. Errors: as those of parse_duration.
std::variant<Duration, DurationError> parse_percentage(std::string_view percent);

/// Exact, in the greatest unit of ns, us, ms, s that is not greater than the value: "28 ms", "1.5 s", "0 ms".
std::string to_text(Duration value);

/// "0.1 ms" if both ends are the same, else "0.1 TO 0.2 ms" in the unit of the worst.
std::string to_text(const Interval& value);

}  // namespace pal
