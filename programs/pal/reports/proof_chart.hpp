// The chart of a verdict's witness, and a measured run laid over it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/chart/options.hpp"
#include "pal/trace/measure.hpp"
#include "pal/trace/trace.hpp"
#include "programs/pal/session/proof.hpp"

namespace pal::program {

/// Whether the witness of a verdict shows what the verdict says, in a finite run that is worse than others.
/// False for a load, and for a run in which nothing is lost.
bool has_worst_run(const analyzer::Verdict& verdict);

/// The requirement that is shown by default: the first that fails, else the one that comes nearest to its
/// limit. Only requirements with a worst run count; nothing if there is none.
std::optional<std::size_t> most_interesting(const Proof& proof);

/// The statements that requirement `index` is about, by their names in traces.
std::vector<trace::StatementName> statements_of(const Proof& proof, std::size_t index);

/// Whether longest_in can measure a requirement in a trace: an age of a condition, or a response, of the
/// whole run.
bool shows_in_runs(const analyzer::Requirement& requirement);

/// The longest interval of requirement `index` (an age or a response) in a trace of the same skill; nothing
/// if it has none.
std::optional<trace::Occurrence> longest_in(const trace::Trace& run, const Proof& proof, std::size_t index);
/// The same of a run whose events come from `events`; of `tables` only the tables count.
std::optional<trace::Occurrence> longest_in(const trace::Trace& tables, const trace::EventSource& events,
                                            const Proof& proof, std::size_t index);

/// A run that is shown for a requirement, and what its chart points out.
struct ShownRun {
  std::string name;  // "worst run"
  trace::Trace run;
  analyzer::chart::ChartOptions options;
  std::vector<analyzer::Reason> reasons;  // all that options.explanation is taken from
};

/// A part of a story, as charts show it. `depth`: how many other parts contain it.
analyzer::chart::Segment segment_of(const analyzer::Reason& reason, int depth);

/// The run behind verdict `index`: its worst. For losses, with what comes after the loss, or a run in which
/// nothing is lost. Without a worst run: a run with the worst times, if that shows a value; nothing if there
/// is none.
std::optional<ShownRun> shown_run(const Proof& proof, std::size_t index);

/// The run `measured` of the same skill as it is shown for requirement `index`.
ShownRun measured_run(const Proof& proof, std::size_t index, const trace::Trace& measured);

/// SVG of `measured` over the witness of verdict `index`, which has one; aligned at the beginnings of the
/// longest intervals of the two.
std::string overlay_chart(const Proof& proof, std::size_t index, const trace::Trace& measured,
                          bool narrow = false);

}  // namespace pal::program
