// The proved bounds of a skill, beside the values of one run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pal/runtime/outcome.hpp"
#include "pal/support/time.hpp"
#include "pal/trace/spool.hpp"
#include "pal/trace/trace.hpp"
#include "programs/workcell/session/skills.hpp"

namespace pal::workcell {

/// One requirement, what was proved of it, and what the run came to.
struct Promise {
  std::string requirement;
  std::string measure;  // "age of pc-force at TXM( motion to MC1 ) in SM1"
  runtime::BrokenPromise::Unit unit = runtime::BrokenPromise::Unit::time;
  std::optional<Duration> proved;  // the bound; nothing: none was found
  bool at_least = false;           // the bound is one from below
  bool exact = false;
  std::optional<Duration> measured;  // the worst of the run; nothing: it has none
  std::string chart;                 // SVG: the run laid over the worst one; empty: there is none

  /// A load is of the long run: a run that ends may have a greater one.
  bool kept() const {
    if (!measured || !proved || unit == runtime::BrokenPromise::Unit::share) return true;
    return at_least ? *measured >= *proved : *measured <= *proved;
  }
};

/// The times that a machine adds to the declared ones, as RealTime has them.
struct Tolerances {
  Duration device{};  // answers come sooner or later by this, events have so much more jitter
  Duration cost{};    // sends, receives, tests, and what sets or reads conditions take so much longer
};

/// Proves the skill from the PAL that it was generated from, and lays the run beside it. Throws Failure if
/// this pal finds the PAL wrong. A skill that names no PAL has no promises. What is proved holds with the
/// tolerances, too.
std::vector<Promise> promises(const KnownSkill& skill, const runtime::Outcome& outcome,
                              const trace::EventSpool* events = nullptr, const Tolerances& tolerances = {});

}  // namespace pal::workcell
