// A skill of skills_pal in a scene of the workcell, from its start until the arm has come to rest.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "programs/workcell/session/session.hpp"
#include "tests/run/skills/support/slower.hpp"

namespace pal::test {

struct PhysicalRun {
  std::string skill;
  std::string scene;  // in sim/scenes or tests/run/skills/scenes
  std::vector<runtime::ParameterValue> parameters{};
  std::uint64_t seed = 1;
  std::optional<runtime::Time> phase{};  // of ALTER; by the seed if not given
  double raise = 0;                      // of the start, mm
  std::optional<Slower> slower{};        // than in workcell.pal
  std::string fault{};                   // as in a file of faults: "at 500 ms range-finder unplug"
  std::string lines{};                   // more lines of the scene: "machine exact"
};

/// Throws sim::SceneError; std::runtime_error if there is no such skill.
workcell::SessionResult run(const PhysicalRun& wanted);

/// How it ended, by the skill's name and its completion code: "press 2". The script
/// tests/run/skills/endings.py looks for comparisons with this text. Each completion of each template has
/// one.
std::string end_of(const runtime::Outcome& outcome);

/// The scene of this name.
sim::Scene scene(const std::string& name);

/// How hard the tool presses along its own axis, N, without the sensor's noise and delay. It is the sensor's
/// true load less what it was at the start. Of each sample of the log.
std::vector<double> pressing(const workcell::SessionResult& result);

}  // namespace pal::test
