#include "programs/pal/reports/chart_caption.hpp"

#include "analyzer/chart/chart.hpp"
#include "programs/pal/session/measure_text.hpp"

namespace pal::program {
namespace {

using analyzer::Figure;
using analyzer::Limit;

/// As charts write times: "35 ms"; of a loss its number, of a load its share.
std::string length_text(Figure figure) {
  return figure.unit == Figure::Unit::time ? analyzer::chart::duration_text(figure.value) : text(figure);
}

/// "35 ms", "2 lost", "none lost".
std::string caption_value(Figure figure) {
  return length_text(figure) + (figure.unit == Figure::Unit::count ? " lost" : "");
}

std::string limit_text(const Limit& limit) {
  return "limit " + length_text(limit.figure);
}

/// By how much a value keeps within its limit, or does not.
std::string caption_margin(const Limit& limit, std::int64_t value) {
  const std::int64_t margin = limit.margin(value);
  if (margin >= 0) return "margin " + length_text({limit.figure.unit, margin});
  return length_text({limit.figure.unit, -margin}) +
         (limit.sense == Limit::Sense::at_least ? " too little" : " too much");
}

std::string with_limit(const std::string& known, const Limit& limit, std::int64_t value) {
  return known + ", " + limit_text(limit) + ", " + caption_margin(limit, value);
}

std::string bound_of(const analyzer::Verdict& verdict) {
  const Figure bound = figure_of(verdict.measure, *verdict.bound);
  const std::string value = caption_value(bound);
  if (verdict.exact && bound.unit == Figure::Unit::count && verdict.witness && verdict.bound->count() > 0)
    return "worst case " + value + " (exact: by " +
           analyzer::chart::duration_text(verdict.witness->measured.at) + ")";
  if (verdict.exact && bound.unit != Figure::Unit::time) return "worst case " + value + " (exact)";
  if (verdict.exact) return "worst case " + value + " (exact: the run below attains it)";
  return std::string(verdict.allowed().text()) + " " + value + " (a bound; no run is known to attain it)";
}

std::string figures_of(const analyzer::Verdict& verdict) {
  if (verdict.bound) return with_limit(bound_of(verdict), verdict.allowed(), verdict.bound->count());
  std::string known = "no bound is known";
  if (verdict.loop_growth) {
    const Duration shown(verdict.loop_growth->first_turns.measured.value);
    known = "grows with each turn of a loop, without bound, " +
            caption_value(figure_of(verdict.measure, shown)) + " in these first turns";
  } else if (verdict.witness && verdict.witness->failed) {
    known = "an event has no response in this run";
  } else if (const auto shown = worth_telling(verdict)) {
    known += ", " + caption_value(figure_of(verdict.measure, *shown)) + " in this run";
  }
  return known + ", " + limit_text(verdict.allowed());
}

}  // namespace

analyzer::chart::Caption proof_caption(const Proof& proof, std::size_t index) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  analyzer::chart::Caption made;
  made.requirement = verdict.requirement;
  made.measure = measure_text(proof.problem, index);
  made.verdict = analyzer::name(verdict.state);
  made.figures = figures_of(verdict);
  made.limit = length_text(verdict.allowed().figure);
  if (verdict.bound)
    made.proved = std::string(verdict.allowed().text()) + " " +
                  caption_value(figure_of(verdict.measure, *verdict.bound));
  return made;
}

std::string shown_figures(const analyzer::Requirement& requirement, Duration value) {
  return with_limit(caption_value(figure_of(requirement.measure, value)) + " in this run",
                    requirement.allowed(), value.count());
}

}  // namespace pal::program
