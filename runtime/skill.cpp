#include "runtime/skill.hpp"

#include <cmath>
#include <sstream>
#include <string>

namespace pal::runtime {

namespace {

std::string with_unit(double value, std::string_view unit) {
  std::ostringstream out;
  out << value;
  if (!unit.empty()) out << ' ' << unit;
  return out.str();
}

}  // namespace

void check_parameter(const ParameterSpec& parameter, double value) {
  const std::string name(parameter.name);
  const bool in_range = value >= parameter.low && value <= parameter.high;  // false for NaN as well
  if (!in_range) {
    throw ParameterError("parameter " + name + " is " + with_unit(value, parameter.unit) +
                         "; it may be from " + with_unit(parameter.low, {}) + " to " +
                         with_unit(parameter.high, parameter.unit));
  }
  if (parameter.type != ParameterType::real && value != std::floor(value)) {
    throw ParameterError("parameter " + name + " is " + with_unit(value, parameter.unit) +
                         "; it must be a whole number");
  }
}

void unknown_parameter(const SkillDescription& skill, std::string_view name) {
  std::string text = "skill " + std::string(skill.name) + " has no parameter " + std::string(name);
  std::string_view separator = "; it has ";
  for (const ParameterSpec& parameter : skill.parameters) {
    text += std::string(separator) + std::string(parameter.name);
    separator = ", ";
  }
  throw ParameterError(text);
}

}  // namespace pal::runtime
