#include "analyzer/analysis.hpp"

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/explain.hpp"
#include "analyzer/run_search.hpp"
#include "analyzer/story.hpp"

namespace pal::analyzer {
namespace {

using State = Verdict::State;

bool has_undecided(const Analysis& analysis) {
  for (const Verdict& verdict : analysis.verdicts) {
    if (verdict.state == State::undecided) return true;
  }
  return false;
}

/// What the compositional analysis adds to an exact one that came to no end.
void complete(Verdict& verdict, Verdict bound) {
  if (verdict.state != State::undecided) return;
  if (!bound.bound) {
    verdict.explanation += " " + bound.explanation;
    return;
  }
  if (verdict.bound && *verdict.bound <= *bound.bound) return;
  bound.witness = std::move(verdict.witness);
  bound.reasons = std::move(verdict.reasons);
  bound.explanation += " The exact analysis: " + verdict.explanation;
  bound.statistics += verdict.statistics;
  verdict = std::move(bound);
}

bool beyond(const Requirement& requirement, const Witness& witness) {
  const Nanoseconds value = witness.measured.value;
  return witness.failed || (requirement.at_least ? value < requirement.limit : value > requirement.limit);
}

bool says_more(const Requirement& requirement, const Witness& found, const std::optional<Witness>& known) {
  if (!known || found.failed) return true;
  if (known->failed || known->grows) return false;
  return requirement.at_least ? found.measured.value < known->measured.value
                              : found.measured.value > known->measured.value;
}

/// What a run that was found by chance makes of a verdict: that it fails, that its bound is attained, or an
/// example.
void confront(const Problem& problem, const Requirement& requirement, Witness found, Verdict& verdict) {
  if (!says_more(requirement, found, verdict.witness)) return;
  const bool fails = beyond(requirement, found);
  const bool attains = verdict.bound && !found.failed && found.measured.value == verdict.bound->count();
  verdict.witness = std::move(found);
  verdict.reasons = reasons(problem, requirement, *verdict.witness);
  if (fails) verdict.state = State::fails;
  verdict.exact = attains || verdict.witness->failed;
  if (verdict.witness->failed) verdict.bound.reset();
  if (fails || attains) verdict.explanation = explanation(problem, requirement, verdict);
}

/// Looks for runs where a bound is not known to be attained.
void search(const Problem& problem, const Options& options, Analysis& analysis) {
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r) {
    Verdict& verdict = analysis.verdicts[r];
    const bool open = verdict.state == State::undecided || (verdict.state == State::holds && !verdict.exact);
    if (!open) continue;
    RunSearchOptions how;
    how.stop = options.stop;
    if (verdict.bound) how.bound = verdict.bound->count();
    auto found = search_runs(problem, problem.requirements[r], how);
    if (found) confront(problem, problem.requirements[r], std::move(*found), verdict);
  }
}

}  // namespace

Analysis analyze(const Problem& problem, AnalysisChoice choice, const Options& options) {
  if (choice == AnalysisChoice::compositional) {
    Analysis analysis = analyze_compositionally(problem, options);
    search(problem, options, analysis);
    return analysis;
  }
  Analysis analysis = analyze(problem, options);
  if (choice == AnalysisChoice::exact || !has_undecided(analysis)) {
    search(problem, options, analysis);
    return analysis;
  }
  // Its time is short, and what it is for is the case in which the other one's has run out.
  Options quick = options;
  quick.stop = nullptr;
  Analysis second = analyze_compositionally(problem, quick);
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r) {
    complete(analysis.verdicts[r], std::move(second.verdicts[r]));
  }
  analysis.statistics.seconds += second.statistics.seconds;
  search(problem, options, analysis);
  return analysis;
}

}  // namespace pal::analyzer
