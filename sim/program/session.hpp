// One run of a skill in a scene: everything that decides how it goes, and what came of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/dispatcher.hpp"
#include "sim/picture/picture.hpp"
#include "sim/scene.hpp"
#include "sim/workcell.hpp"

namespace pal::workcell {

struct Session {
  sim::Scene scene;
  std::vector<runtime::ParameterValue> parameters;
  runtime::CostPolicy times = runtime::CostPolicy::random;
  std::uint64_t seed = 1;
  /// From the opening of ALTER to its first event; drawn by the seed if not given.
  std::optional<runtime::Time> phase;
  /// How much higher than in the scene the tool starts, mm.
  double raise = 0;
  bool picture = false;
};

struct SessionResult {
  runtime::Outcome outcome;
  runtime::Time phase{};         // as given or drawn
  std::vector<sim::Sample> log;  // until the arm has come to rest
  double peak_force = 0;         // N
  double resting_force = 0;      // N, at the end of the log
  sim::Picture picture;
};

/// Runs the skill, then lets the arm end its motion and come to rest. Throws sim::SceneError;
/// std::runtime_error when the physics diverged after the skill's end (before it, that is a fault of the
/// skill).
SessionResult run_session(runtime::Skill& skill, const Session& session);

/// The value that the session gives a parameter, or its default; nothing if the skill has none of that name.
std::optional<double> parameter_value(const runtime::Skill& skill, const Session& session,
                                      std::string_view name);

/// Likewise of a parameter that is a text.
std::string text_parameter(const runtime::ParameterSpec& parameter, const Session& session);

}  // namespace pal::workcell
