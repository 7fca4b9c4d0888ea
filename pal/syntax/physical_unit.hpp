// Units of messages and parameters: mm, N*m, deg/s, m/s^2.
#pragma once

#include <string>
#include <string_view>

namespace pal::syntax {

/// True of a product or quotient of known units with small whole powers, spelt without spaces.
bool is_physical_unit(std::string_view spelling);

/// The known units, for a message.
std::string physical_units();

}  // namespace pal::syntax
