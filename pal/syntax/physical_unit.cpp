#include "pal/syntax/physical_unit.hpp"

#include "pal/units/unit.hpp"

namespace pal::syntax {

bool is_physical_unit(std::string_view spelling) {
  return units::parse_unit(spelling).has_value();
}

std::string physical_units() {
  return units::known_units();
}

}  // namespace pal::syntax
