#include "programs/workcell/reports/force_options.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pal::workcell {
namespace {

constexpr double counts = 20;  // a newton, of the force-torque sensor

/// N, positive when the tool presses; nothing: it is no force.
std::optional<double> newtons(const runtime::Skill& skill, const Session& session,
                              const runtime::ParameterSpec& parameter) {
  if (parameter.unit != "N" && parameter.unit != "count") return std::nullopt;
  const double value = *parameter_value(skill, session, parameter.name);
  return parameter.unit == "N" ? value : std::abs(value) / counts;
}

bool begins(const runtime::ParameterSpec& parameter, std::string_view one, std::string_view other) {
  return parameter.name.starts_with(one) || parameter.name.starts_with(other);
}

}  // namespace

sim::ForcePlotOptions force_options(const runtime::Skill& skill, const Session& session,
                                    const std::string& title, runtime::Time end) {
  sim::ForcePlotOptions options{title, {}, {}, end};
  std::optional<double> least, greatest, middle, around;
  for (const runtime::ParameterSpec& parameter : skill.description().parameters) {
    const auto value = newtons(skill, session, parameter);
    if (!value) continue;
    if (parameter.name == "band") {
      around = value;
      continue;
    }
    if (begins(parameter, "min", "least")) least = value;
    if (begins(parameter, "max", "greatest")) greatest = value;
    if (parameter.name == "force") middle = value;
    options.levels.push_back({std::string(parameter.name), *value});
  }
  if (least && greatest) options.bands.push_back({"", *least, *greatest});
  if (middle && around) options.bands.push_back({"", std::max(0.0, *middle - *around), *middle + *around});
  return options;
}

}  // namespace pal::workcell
