// The same skill many times (`workcell run --sweep`), over the phases of its clocks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pal/trace/measure.hpp"
#include "programs/workcell/session/session.hpp"
#include "programs/workcell/session/skills.hpp"

namespace pal::workcell {

/// One run of a sweep. Forces in N.
struct SweepRun {
  runtime::Time phase{};  // of ALTER
  double raise = 0;       // mm, of the tool's start
  std::uint64_t seed = 0;
  int completion = 0;
  bool fault = false;
  double peak_force = 0;
  double resting_force = 0;
  double overshoot = 0;  // peak less threshold
  /// Age of the subject's condition at the last of its statements.
  std::optional<runtime::Time> age;
  /// The greatest age at any of them: what the proof bounds.
  std::optional<runtime::Time> greatest_age;
};

/// What a sweep of a skill is about, as the PAL of the skill says.
struct SweepSubject {
  std::string speed;                     // the parameter in mm/s: how fast the tool comes to what it meets
  std::string threshold;                 // the parameter in N: the force past which it presses
  std::string condition;                 // the skill requires an age of it …
  std::vector<trace::StatementName> at;  // … at these statements, in any line
};

/// The subject of a skill: its first requirement of the age of a condition, and its only parameters in mm/s
/// and in N. Throws Failure for a skill that lacks one of these, or has several such parameters.
SweepSubject sweep_subject(const KnownSkill& skill);

/// Runs the skill `count` times. The phase of ALTER's clock is spread evenly over its period. Where in that
/// cycle the tool meets the surface does not depend on the phase, since the tool moves by that clock. So it
/// is spread evenly, and independently, by starting up to one cycle's travel higher. The phase of the
/// sensor's clock follows from a seed of its own for each run. Two skills swept with the same session meet
/// the same phases, heights and seeds.
std::vector<SweepRun> sweep(runtime::Skill& skill, const SweepSubject& subject, const Session& session,
                            int count);

}  // namespace pal::workcell
