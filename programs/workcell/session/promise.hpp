// The proved bounds of a skill, beside the values of one run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pal/support/time.hpp"
#include "pal/trace/spool.hpp"
#include "pal/trace/trace.hpp"
#include "programs/workcell/session/skills.hpp"

namespace pal::workcell {

/// One requirement with a worst run: an age or a response.
struct Promise {
  std::string requirement;
  std::string measure;  // "age of pc-force at TXM( motion to MC1 ) in SM1"
  Duration proved{};
  bool exact = false;
  std::optional<Duration> measured;  // the longest of the run; nothing: it has none
  std::string chart;                 // SVG: the run laid over the worst one

  bool kept() const { return !measured || *measured <= proved; }
};

/// Proves the skill from the PAL that it was generated from, and finds the same intervals in `run`. Throws
/// Failure if this pal finds the PAL wrong. A skill that names no PAL has no promises.
std::vector<Promise> promises(const KnownSkill& skill, const trace::Trace& run,
                              const trace::EventSpool* events = nullptr);

}  // namespace pal::workcell
