#include "tests/run/skills/endings/truth.hpp"
#include "tests/support/built_skills.hpp"

#include <algorithm>
#include <numbers>

namespace pal::test {

namespace {

const runtime::ParameterSpec& spec(const std::string& skill, const std::string& name) {
  static std::map<std::string, std::unique_ptr<runtime::Skill>> made;
  auto& known = made[skill];
  if (!known) known = test::make_skill(skill);
  for (const runtime::ParameterSpec& each : known->description().parameters)
    if (each.name == name) return each;
  throw std::runtime_error(skill + " has no parameter " + name);
}

}  // namespace

double Ended::parameter(const std::string& name) const {
  for (const runtime::ParameterValue& given : parameters)
    if (given.name == name) return given.value;
  return spec(outcome.trace.skill, name).default_value;
}

std::string Ended::text(const std::string& name) const {
  for (const runtime::ParameterValue& given : parameters)
    if (given.name == name && given.text) return *given.text;
  return std::string(spec(outcome.trace.skill, name).default_text);
}

std::span<const sim::Sample> Ended::during() const {
  const auto all = shop.log();
  const runtime::Time begun = shop.cell().station().begun();
  const auto first = [&](runtime::Time when) {
    return std::lower_bound(all.begin(), all.end(), when,
                            [](const sim::Sample& sample, runtime::Time at) { return sample.time < at; });
  };
  return {first(begun), first(begun + outcome.duration)};
}

bool Ended::stands_still() const {
  const auto& log = shop.cell().workcell().log();
  if (log.size() < 100) return true;
  return 1e3 * (log.back().tool - log[log.size() - 100].tool).norm() < 0.05;
}

double Ended::moved() const {
  return 1e3 * (after().tool - before.tool).norm();
}

double Ended::turned() const {
  return after().tool_turn.angularDistance(before.tool_turn) * 180 / std::numbers::pi;
}

double Ended::pressing(const sim::Sample& sample) const {
  // The tool's weight is what hangs on the sensor at the start, turned with the tool.
  const sim::Wrench weight = shop.cell().workcell().tool_weight();
  return weight.force.z() - sample.wrench.force.z();
}

}  // namespace pal::test
