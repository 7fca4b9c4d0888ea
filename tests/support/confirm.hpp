// Witnesses held against the referee.
#pragma once

#include <string>

#include "analyzer/exact/exact.hpp"
#include "analyzer/run_checker/check_run.hpp"

namespace pal::test {

inline bool shows(const analyzer::run_checker::Ruling& ruling, const analyzer::Measurement& measured) {
  for (const analyzer::run_checker::Measured& each : ruling.measured) {
    if (each.value == measured.value && each.born == measured.born && each.at == measured.at) return true;
  }
  return false;
}

/// Why `run` does not show what `witness` claims of the requirement; empty: it does.
inline std::string refusal(const analyzer::Problem& problem, const analyzer::Requirement& requirement,
                           const analyzer::Witness& witness, const trace::Trace& run) {
  const analyzer::Measurement& measured = witness.measured;
  const auto until = witness.grows ? std::optional(measured.at) : std::nullopt;
  const analyzer::run_checker::Ruling ruling =
      analyzer::run_checker::check_run(problem, &requirement, run, until);
  if (!ruling.broken.empty()) return ruling.broken;
  if (requirement.measure == analyzer::Requirement::Measure::load) return {};
  if (witness.grows) {
    const bool grown = ruling.growing_since && *ruling.growing_since <= measured.born &&
                       measured.at - measured.born == measured.value;
    return grown ? "" : "nothing has grown so far";
  }
  if (witness.failed) return ruling.failed ? "" : "every event has its response";
  return shows(ruling, measured) ? "" : "the value is not shown";
}

/// The first requirement whose witness the referee does not confirm, and why; empty: it confirms all.
inline std::string unconfirmed(const analyzer::Problem& problem, const analyzer::Analysis& analysis) {
  for (std::size_t i = 0; i < analysis.verdicts.size(); ++i) {
    const auto& witness = analysis.verdicts[i].witness;
    if (!witness) continue;
    const std::string why = refusal(problem, problem.requirements[i], *witness, witness->trace);
    if (!why.empty()) return analysis.verdicts[i].requirement + ": " + why;
  }
  return {};
}

/// Where the pieces between two instants have a gap, or those inside one of them. Empty: there is no gap.
inline std::string gap_in(const std::vector<analyzer::Reason>& reasons, analyzer::Nanoseconds from,
                          analyzer::Nanoseconds to) {
  analyzer::Nanoseconds at = from;
  for (const analyzer::Reason& reason : reasons) {
    if (reason.from != at || reason.to < reason.from) return "a gap at " + std::to_string(at) + " ns";
    if (!reason.inside.empty()) {
      const std::string why = gap_in(reason.inside, reason.from, reason.to);
      if (!why.empty()) return why + ", inside " + reason.actor + " " + reason.what;
    }
    at = reason.to;
  }
  return at == to ? "" : "it ends at " + std::to_string(at) + " ns";
}

/// Why the pieces that explain a verdict do not make up the value of its witness (of the first turns, if the
/// value grows in a loop); empty: they do, without gaps.
inline std::string unexplained(const analyzer::Verdict& verdict) {
  if (verdict.reasons.empty() || !verdict.witness) return {};
  const analyzer::Witness& shown = verdict.loop_growth ? verdict.loop_growth->first_turns : *verdict.witness;
  return gap_in(verdict.reasons, shown.measured.born, shown.measured.at);
}

}  // namespace pal::test
