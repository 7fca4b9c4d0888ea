// The same skill many times (`workcell run --sweep`), over the phases of its clocks.
#pragma once

#include <optional>
#include <vector>

#include "programs/workcell/session/session.hpp"

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
  /// Age of the condition pc-force when the last motion that was decided on it was sent.
  std::optional<runtime::Time> age;
  /// The greatest age at any of the run's motions: what the proof bounds.
  std::optional<runtime::Time> greatest_age;
};

/// Runs the skill `count` times. The phase of ALTER's clock is spread evenly over its 28 ms. Where in that
/// cycle the tool meets the surface does not depend on the phase, since the tool moves by that clock. So it
/// is spread evenly, and independently, by starting up to one cycle's travel higher. The phase of the
/// sensor's clock follows from a seed of its own for each run. Two skills swept with the same session meet
/// the same phases, heights and seeds.
std::vector<SweepRun> sweep(runtime::Skill& skill, const Session& session, int count);

}  // namespace pal::workcell
