#include "programs/pal/reports/chart_caption.hpp"

#include "analyzer/chart/chart.hpp"
#include "programs/pal/session/measure_text.hpp"

namespace pal::program {
namespace {

using Measure = analyzer::Requirement::Measure;

/// As charts write times: "35 ms"; of a loss its number, of a load its share.
std::string length_text(Measure measure, Duration value) {
  const bool is_time = measure != Measure::loss && measure != Measure::load;
  return is_time ? analyzer::chart::duration_text(value.count()) : figure_text(measure, value);
}

/// "35 ms", "2 lost", "none lost".
std::string caption_value(Measure measure, Duration value) {
  return length_text(measure, value) + (measure == Measure::loss ? " lost" : "");
}

std::string limit_text(Measure measure, Duration limit) {
  return "limit " + length_text(measure, limit);
}

/// By how much a value keeps within its limit, or does not.
std::string caption_margin(Measure measure, bool at_least, Duration limit, Duration value) {
  const Duration margin = at_least ? value - limit : limit - value;
  if (margin >= Duration::zero()) return "margin " + length_text(measure, margin);
  return length_text(measure, -margin) + (at_least ? " too little" : " too much");
}

std::string with_limit(const std::string& known, Measure measure, bool at_least, Duration limit,
                       Duration value) {
  return known + ", " + limit_text(measure, limit) + ", " + caption_margin(measure, at_least, limit, value);
}

std::string bound_of(const analyzer::Verdict& verdict) {
  const std::string value = caption_value(verdict.measure, *verdict.bound);
  if (verdict.exact && verdict.measure == Measure::loss && verdict.witness && verdict.bound->count() > 0)
    return "worst case " + value + " (exact: by " +
           analyzer::chart::duration_text(verdict.witness->measured.at) + ")";
  const bool shown = verdict.measure != Measure::load && verdict.measure != Measure::loss;
  if (verdict.exact && !shown) return "worst case " + value + " (exact)";
  if (verdict.exact) return "worst case " + value + " (exact: the run below attains it)";
  return (verdict.at_least ? "at least " : "at most ") + value + " (a bound; no run is known to attain it)";
}

std::string figures_of(const analyzer::Verdict& verdict) {
  if (verdict.bound)
    return with_limit(bound_of(verdict), verdict.measure, verdict.at_least, verdict.limit, *verdict.bound);
  std::string known = "no bound is known";
  if (verdict.loop_growth) {
    const Duration shown(verdict.loop_growth->first_turns.measured.value);
    known = "grows with each turn of a loop, without bound, " + caption_value(verdict.measure, shown) +
            " in these first turns";
  } else if (verdict.witness && verdict.witness->failed) {
    known = "an event has no response in this run";
  } else if (const auto shown = worth_telling(verdict)) {
    known += ", " + caption_value(verdict.measure, *shown) + " in this run";
  }
  return known + ", " + limit_text(verdict.measure, verdict.limit);
}

}  // namespace

analyzer::chart::Caption proof_caption(const Proof& proof, std::size_t index) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  analyzer::chart::Caption made;
  made.requirement = verdict.requirement;
  made.measure = measure_text(proof.problem, index);
  made.verdict = analyzer::name(verdict.state);
  made.figures = figures_of(verdict);
  made.limit = length_text(verdict.measure, verdict.limit);
  if (verdict.bound)
    made.proved =
        (verdict.at_least ? "at least " : "at most ") + caption_value(verdict.measure, *verdict.bound);
  return made;
}

std::string shown_figures(const analyzer::Requirement& requirement, Duration value) {
  return with_limit(caption_value(requirement.measure, value) + " in this run", requirement.measure,
                    requirement.at_least, Duration(requirement.limit), value);
}

}  // namespace pal::program
