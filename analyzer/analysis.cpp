#include "analyzer/analysis.hpp"

#include "analyzer/compositional/compositional.hpp"

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
  const bool nearer =
      verdict.bound && (verdict.at_least ? *verdict.bound >= *bound.bound : *verdict.bound <= *bound.bound);
  if (nearer) return;
  bound.witness = std::move(verdict.witness);
  bound.reasons = std::move(verdict.reasons);
  bound.explanation += " The exact analysis: " + verdict.explanation;
  verdict = std::move(bound);
}

}  // namespace

Analysis analyze(const Problem& problem, AnalysisChoice choice, const Options& options) {
  if (choice == AnalysisChoice::compositional) return analyze_compositionally(problem, options);
  Analysis analysis = analyze(problem, options);
  if (choice == AnalysisChoice::exact || !has_undecided(analysis)) return analysis;
  // Its time is short, and what it is for is the case in which the other one's has run out.
  Options quick = options;
  quick.stop = nullptr;
  Analysis second = analyze_compositionally(problem, quick);
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r) {
    complete(analysis.verdicts[r], std::move(second.verdicts[r]));
  }
  analysis.statistics.seconds += second.statistics.seconds;
  return analysis;
}

}  // namespace pal::analyzer
