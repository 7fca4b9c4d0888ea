#include "pal/syntax/physical_unit.hpp"

#include <algorithm>
#include <array>

namespace pal::syntax {

namespace {

constexpr std::array<std::string_view, 31> known{
    "m",   "mm", "um",  "cm", "km", "N", "mN", "kN", "kg", "g", "s",    "ms", "us",  "ns",  "min",  "rad",
    "deg", "Hz", "kHz", "V",  "mV", "A", "mA", "W",  "J",  "K", "degC", "Pa", "kPa", "bar", "count"};

bool is_factor(std::string_view factor) {
  const auto mark = factor.find('^');
  const auto base = factor.substr(0, mark);
  if (std::find(known.begin(), known.end(), base) == known.end()) return false;
  if (mark == std::string_view::npos) return true;
  auto power = factor.substr(mark + 1);
  if (power.starts_with('-')) power.remove_prefix(1);
  return power.size() == 1 && power[0] >= '1' && power[0] <= '9';
}

}  // namespace

bool is_physical_unit(std::string_view spelling) {
  if (spelling == "%") return true;
  while (true) {
    const auto sign = spelling.find_first_of("*/");
    if (!is_factor(spelling.substr(0, sign))) return false;
    if (sign == std::string_view::npos) return true;
    spelling.remove_prefix(sign + 1);
  }
}

std::string physical_units() {
  std::string result;
  for (const auto unit : known) result += (result.empty() ? "" : ", ") + std::string(unit);
  return result + "; or %";
}

}  // namespace pal::syntax
