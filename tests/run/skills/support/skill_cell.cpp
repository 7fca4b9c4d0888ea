#include "tests/run/skills/support/skill_cell.hpp"

#include <stdexcept>

#include "sim/val/transformation.hpp"
#include "skills_pal/registry.hpp"
#include "tests/run/skills/support/physical_run.hpp"

namespace pal::test {

namespace {

sim::CellOptions options(std::uint64_t seed) {
  sim::CellOptions options;
  options.seed = seed;
  return options;
}

}  // namespace

SkillCell::SkillCell(const std::string& scene_name, std::uint64_t seed)
    : cell_(scene(scene_name), options(seed)) {}

void SkillCell::teach(const std::string& location, double x, double y, double z) {
  cell_.val_store().locations[location] = sim::val::pose_of({x, y, z, -90, 90, 0});
}

runtime::Outcome SkillCell::run(const std::string& skill,
                                const std::vector<runtime::ParameterValue>& parameters) {
  const auto made = skills::make_skill(skill);
  if (!made) throw std::runtime_error("there is no skill " + skill);
  auto outcome = cell_.run(*made, parameters);
  cell_.rest(std::chrono::milliseconds(400));
  return outcome;
}

runtime::ParameterValue text(const std::string& name, const std::string& value) {
  runtime::ParameterValue parameter;
  parameter.name = name;
  parameter.text = value;
  return parameter;
}

}  // namespace pal::test
