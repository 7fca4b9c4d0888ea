#include "analyzer/whatif/figure_search.hpp"

#include <algorithm>

namespace pal::analyzer::whatif {
namespace {

RequirementIds requirements_that(const Problem& problem, bool are_loads) {
  RequirementIds chosen;
  for (const RequirementId r : requirements_of(problem)) {
    const bool load = problem.requirements[r.index()].measure == Requirement::Measure::load;
    if (load == are_loads) chosen.push_back(r);
  }
  return chosen;
}

}  // namespace

FigureSearch::FigureSearch(const pan::Environment& environment, std::vector<std::string> names,
                           const Problem& problem)
    : scaling_(environment, std::move(names)),
      timed_(scaling_, requirements_that(problem, false), false),
      loads_(scaling_, requirements_that(problem, true), true),
      unbounded_(scaling_.most() + 1),
      step_(std::max<Nanoseconds>(scaling_.longest(), 1'000)) {}

void FigureSearch::bound(RequirementChecker& checker, const RequirementIds& all, const Effort& effort) {
  const Nanoseconds before = bounded_;
  while (unbounded_ - bounded_ > 1 && !effort.over()) {
    const bool looking = unbounded_ > scaling_.most();
    const Nanoseconds up = scaling_.most() - bounded_ <= step_ ? scaling_.most() : bounded_ + step_;
    const Nanoseconds extra = looking ? up : bounded_ + (unbounded_ - bounded_) / 2;
    const auto problem = checker.problem(scaling_.by(extra));
    (problem && checker.bounded(*problem, all) ? bounded_ : unbounded_) = extra;
    step_ = step_ < scaling_.most() / 100 ? step_ * 100 : scaling_.most();
  }
  if (bounded_ == before) return;
  const auto problem = checker.problem(scaling_.by(bounded_));
  if (!problem || checker.has_zeno_run(*problem)) return;
  timed_.hold(bounded_);
  loads_.hold(bounded_);
}

void FigureSearch::narrow(RequirementChecker& checker, const Effort& half, const Effort& whole,
                          Precision precision) {
  timed_.narrow(checker, half, precision, ceiling_of(loads_));
  loads_.narrow(checker, whole, precision, ceiling_of(timed_));
  timed_.narrow(checker, whole, precision, ceiling_of(loads_));
}

bool FigureSearch::exact() const {
  return holds() == scaling_.most() || (fails() && *fails() - holds() == 1);
}

bool FigureSearch::exhausted() const {
  return exact() || (timed_.exhausted(ceiling_of(loads_)) && loads_.exhausted(ceiling_of(timed_)));
}

void FigureSearch::tell(Slack& slack) const {
  slack.holds = Duration(holds());
  slack.unlimited = holds() == scaling_.most();
  if (fails()) slack.fails = Duration(*fails());
  const bool timed_says = fails() ? timed_.fails() == fails() : timed_.holds() == holds();
  const bool loads_only = timed_.requirements().empty();
  slack.requirement = (timed_says && !loads_only ? timed_ : loads_).requirement();
}

/// What is of no interest to the others: something fails there.
Nanoseconds FigureSearch::ceiling_of(const Bracket& bracket) const {
  return bracket.fails().value_or(scaling_.most() + 1);
}

Nanoseconds FigureSearch::holds() const {
  if (timed_.requirements().empty()) return loads_.requirements().empty() ? scaling_.most() : loads_.holds();
  return loads_.requirements().empty() ? timed_.holds() : std::min(timed_.holds(), loads_.holds());
}

std::optional<Nanoseconds> FigureSearch::fails() const {
  if (!timed_.fails() || !loads_.fails()) return timed_.fails() ? timed_.fails() : loads_.fails();
  return std::min(timed_.fails(), loads_.fails());
}

}  // namespace pal::analyzer::whatif
