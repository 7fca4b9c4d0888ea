#include "tests/run/skills/support/physical_run.hpp"

#include <stdexcept>
#include <variant>

#include "tests/run/skills/support/workshop.hpp"
#include "tests/support/built_skills.hpp"

namespace pal::test {

std::string end_of(const runtime::Outcome& outcome) {
  return outcome.trace.skill + " " + std::to_string(outcome.code);
}

sim::Scene scene(const std::string& name) {
  return sim::find_scene(name, {PAL_SOURCE_DIR "/sim/scenes", PAL_SOURCE_DIR "/tests/run/skills/scenes"});
}

workcell::SessionResult run(const PhysicalRun& wanted) {
  std::unique_ptr<runtime::Skill> skill = test::make_skill(wanted.skill);
  if (!skill) throw std::runtime_error("there is no skill " + wanted.skill);
  workcell::Session session;
  std::optional<ChangedScene> changed;
  if (!wanted.lines.empty()) changed.emplace(wanted.scene, wanted.lines);
  session.scene = changed ? changed->scene() : scene(wanted.scene);
  session.parameters = wanted.parameters;
  session.seed = wanted.seed;
  session.phase = wanted.phase;
  session.raise = wanted.raise;
  const auto faults = std::get<std::vector<sim::PlannedFault>>(sim::read_faults(wanted.fault));
  for (const sim::PlannedFault& fault : faults) {
    if (fault.kind == sim::PlannedFault::Kind::takes)
      session.slow.push_back({fault.device, fault.statement, fault.by, fault.at});
    else
      session.faults.push_back(fault);
  }
  if (wanted.slower) skill = slow_down(std::move(skill), *wanted.slower);
  return workcell::run_session(*skill, session);
}

std::vector<double> pressing(const workcell::SessionResult& result) {
  std::vector<double> forces;
  for (const sim::Sample& sample : result.log)
    forces.push_back(result.log.front().wrench.force.z() - sample.wrench.force.z());
  return forces;
}

}  // namespace pal::test
