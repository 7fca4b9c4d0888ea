#include "pal/runtime/skill.hpp"

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
  if (parameter.type == ParameterType::text)
    throw ParameterError("parameter " + name + " is a text; it cannot be a number");
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

void check_parameter(const ParameterSpec& parameter, std::string_view text) {
  const std::string name(parameter.name);
  if (parameter.type != ParameterType::text)
    throw ParameterError("parameter " + name + " is a number; it cannot be a text");
  if (Text::fits(text)) return;
  const bool too_long = text.size() > Text::capacity;
  throw ParameterError("parameter " + name +
                       (too_long ? " has " + std::to_string(text.size()) + " characters; it may have up to " +
                                       std::to_string(Text::capacity)
                                 : std::string(" may have printable characters of ASCII only")));
}

void Skill::set_text_parameter(std::string_view name, std::string_view text) {
  for (const ParameterSpec& parameter : description().parameters) {
    if (parameter.name == name) check_parameter(parameter, text);
  }
  unknown_parameter(description(), name);
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
