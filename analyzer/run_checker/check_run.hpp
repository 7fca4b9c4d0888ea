// Confirms a run without the analysis that found it. A referee follows the events of a trace and checks each
// against docs/reference/execution-model.md. It uses nothing of the analysis but the problem's data.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/problem/problem.hpp"
#include "pal/trace/trace.hpp"

namespace pal::analyzer::run_checker {

/// The last instant that a run may have; sums of later ones would overflow.
constexpr Nanoseconds latest_instant = 4'000'000'000'000'000'000;

/// A value of the requirement's measure in the run.
struct Measured {
  Nanoseconds value = 0;  // of a loss: a number
  Nanoseconds born = 0;
  Nanoseconds at = 0;
  StatementId statement{};

  friend bool operator==(const Measured&, const Measured&) = default;
};

struct Ruling {
  /// The first rule that the run breaks, with its instant; empty: it is a run of the problem.
  std::string broken;
  std::vector<Measured> measured;  // before that
  bool failed = false;             // an event of the requirement has no response
  /// Since when a value has been growing that is not measured at the end of the run.
  std::optional<Nanoseconds> growing_since;
  bool stopped = false;  // `stop` said so: nothing is known of the rest of the run
};

/// From which instants a busy period is measured.
enum class BusyFrom {
  each_pause,  // from its beginning, and from each pause of no length in it
  beginning,   // from its beginning only
};

/// Checks `run` against every rule. `requirement`, of `problem`, says what to measure; without it, or for a
/// load, nothing is measured. The run may end at any instant; with `until` nothing may have to happen before
/// that. What arrives or becomes ready at one instant, without an event of its own in the trace, may have
/// come in any order. A busy period is measured once for each instant that `busy_from` names. `stop` is
/// called now and then.
Ruling check_run(const Problem& problem, const Requirement* requirement, const trace::Trace& run,
                 std::optional<Nanoseconds> until = std::nullopt, BusyFrom busy_from = BusyFrom::each_pause,
                 const std::function<bool()>& stop = {});

}  // namespace pal::analyzer::run_checker
