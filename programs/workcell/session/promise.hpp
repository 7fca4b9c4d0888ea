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

/// Proves the skill from its PAL, as it stands in `folders`, and finds the same intervals in `run`. Throws
/// Failure if the PAL cannot be read or is wrong by now. A skill that names no PAL has no promises.
std::vector<Promise> promises(const KnownSkill& skill, const std::vector<std::string>& folders,
                              const trace::Trace& run, const trace::EventSpool* events = nullptr);

}  // namespace pal::workcell
