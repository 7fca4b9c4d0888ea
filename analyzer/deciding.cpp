#include "analyzer/deciding.hpp"

#include <algorithm>
#include <utility>

#include "analyzer/exact/slice_bound.hpp"
#include "analyzer/problem/budgets.hpp"
#include "analyzer/runs/quick_runs.hpp"
#include "analyzer/runs/run_search.hpp"
#include "analyzer/runs/zone_walk.hpp"
#include "analyzer/verdict/confront.hpp"
#include "analyzer/verdict/sentence.hpp"

namespace pal::analyzer {
namespace {

/// Looks for a run that attains the bound, or breaks the requirement.
void look_for_run(const Problem& problem, const Requirement& requirement, const Options& options,
                  const RunSearchOptions& usual, Verdict& verdict) {
  RunSearchOptions how = usual;
  how.stop = options.stop;
  how.steady = verdict.state == VerdictState::undecided ? budget::runs_while_open : 0;
  if (verdict.bound) how.bound = verdict.bound->count();
  auto found = search_runs(problem, requirement, how);
  if (found) confront(problem, requirement, std::move(*found), verdict);
}

/// What has to add up first shows in longer runs.
void look_for_long_run(const Problem& problem, const Requirement& requirement, const Options& options,
                       Verdict& verdict) {
  auto found = simulated_witness(problem, requirement, options.stop, events_for(options.max_states));
  if (found) confront(problem, requirement, std::move(*found), verdict);
}

/// What has to meet within a short time is seldom met by times that are drawn.
void look_by_walks(const Problem& problem, const Requirement& requirement, const Options& options,
                   Verdict& verdict) {
  ZoneWalkOptions how;
  how.steps = std::min(budget::walks_a_class * glance(problem), options.max_states);
  how.stop = options.stop;
  auto found = walk_zones(problem, requirement, how);
  if (found) confront(problem, requirement, std::move(*found), verdict);
}

/// What is shown by leaving out what has no say.
void explore_slice(const Problem& problem, const Requirement& requirement, const Options& options,
                   Verdict& verdict) {
  using Measure = Requirement::Measure;
  const bool timed = requirement.measure != Measure::load && requirement.measure != Measure::busy;
  if (!timed || !fits_exploration(problem)) return;
  const SliceBound found =
      slice_bound(problem, requirement, options, std::min(options.max_states, budget::most_of_slice));
  verdict.statistics += found.statistics;
  if (!found.bound) return;
  const Duration bound(*found.bound);
  if (verdict.bound && !verdict.allowed().worse(*verdict.bound, bound)) return;
  verdict.method = Method::exact;
  verdict.bound = bound;
  verdict.addends.clear();
  verdict.exact = attains(verdict);
  if (!verdict.allowed().broken_by(bound)) verdict.state = VerdictState::holds;
  verdict.explanation =
      verdict.exact
          ? explanation(problem, requirement, verdict)
          : "Found by exploring only what has an influence; no run exceeds it, but none is known to "
            "attain it.";
}

// The methods, each as a step of a decision.

void by_long_run(const OpenCase& open, const Options& options) {
  look_for_long_run(open.problem, open.requirement(), options, open.verdict());
}

void by_runs(const OpenCase& open, const Options& options) {
  look_for_run(open.problem, open.requirement(), options, {}, open.verdict());
}

void by_walks(const OpenCase& open, const Options& options) {
  look_by_walks(open.problem, open.requirement(), options, open.verdict());
}

void by_slice(const OpenCase& open, const Options& options) {
  explore_slice(open.problem, open.requirement(), options, open.verdict());
}

/// If it was not explored as far as that before.
void by_exploration(const OpenCase& open, const Options& options) {
  Options brief = options;
  brief.max_states = std::min(options.max_states, budget::brief_exploration);
  const bool explored = !options.verdicts_only && brief.max_states <= glance(open.problem);
  if (open.verdict().gave_up && !explored)
    explore(open.provers, open.problem, brief, {open.index}, open.bounds, open.analysis);
}

/// What is cheap goes first: runs, as pal simulate makes them.
constexpr DecidingMethod usual_methods[] = {{"long run", false, true, 25, by_long_run},
                                            {"exploration", true, true, 30, by_exploration},
                                            {"single runs", false, true, 30, by_runs},
                                            {"walks through zones", false, true, 30, by_walks},
                                            {"slice", true, false, 60, by_slice}};

/// For an answer as soon as possible. Most requirements hold while their text is edited, and slices show
/// that; runs that break one are looked for before that only for a moment.
constexpr DecidingMethod methods_for_verdicts[] = {{"long run", false, true, 10, by_long_run},
                                                   {"slice", true, false, 70, by_slice},
                                                   {"single runs", false, true, 30, by_runs},
                                                   {"walks through zones", false, true, 50, by_walks},
                                                   {"exploration", true, true, 100, by_exploration}};

}  // namespace

std::size_t glance(const Problem& problem) {
  const std::size_t few = budget::glance_threads;
  const std::size_t threads = std::max(problem.threads.size(), few);
  return std::max(budget::least_glance, budget::brief_exploration * few * few / (threads * threads));
}

void tell(const Options& options, const Analysis& analysis) {
  if (options.known) options.known(analysis);
}

Options share_of(const Options& options, double percent) {
  if (!options.deadline || !options.clock || percent >= 100) return options;
  Options shared = options;
  const double now = options.clock();
  const double end = now + std::max(0.0, *options.deadline - now) * percent / 100;
  shared.deadline = end;
  shared.stop = [stop = options.stop, clock = options.clock, end] {
    return (stop && stop()) || clock() > end;
  };
  return shared;
}

void complete(Verdict& verdict, Verdict bound) {
  if (verdict.state != VerdictState::undecided) return;
  if (!bound.bound) {
    verdict.explanation += " " + bound.explanation;
    return;
  }
  if (verdict.bound && !verdict.allowed().worse(*verdict.bound, *bound.bound)) return;
  bound.witness = std::move(verdict.witness);
  bound.reasons = std::move(verdict.reasons);
  bound.attained_load = verdict.attained_load;
  bound.explanation += " The exact analysis: " + verdict.explanation;
  bound.statistics += verdict.statistics;
  bound.gave_up = verdict.gave_up;
  bound.exact = attains(bound);
  verdict = std::move(bound);
}

void search(const Problem& problem, const Requirement& requirement, const Options& options,
            Verdict& verdict) {
  const bool open =
      verdict.state == VerdictState::undecided || (verdict.state == VerdictState::holds && !verdict.exact);
  if (!open) return;
  look_for_run(problem, requirement, options, {}, verdict);
  if (verdict.state == VerdictState::undecided) look_for_long_run(problem, requirement, options, verdict);
}

void explore(const Provers& provers, const Problem& problem, const Options& options,
             const std::vector<std::size_t>& open, const std::vector<Verdict>& bounds, Analysis& known) {
  Problem rest = problem;
  rest.requirements.clear();
  for (const std::size_t r : open) rest.requirements.push_back(problem.requirements[r]);
  Analysis further = provers.exact(rest, options);
  known.statistics += further.statistics;
  for (std::size_t i = 0; i < open.size(); ++i) {
    Verdict& before = known.verdicts[open[i]];
    Verdict& now = further.verdicts[i];
    const Statistics statistics = now.statistics;
    const bool refuted = now.state == VerdictState::fails && before.state != VerdictState::fails;
    if (now.gave_up && !refuted) {
      if (now.witness && !now.witness->grows)
        confront(problem, rest.requirements[i], std::move(*now.witness), before);
    } else {
      complete(now, bounds[open[i]]);
      search(problem, rest.requirements[i], options, now);
      now.statistics = before.statistics;
      before = std::move(now);
    }
    before.statistics += statistics;
  }
}

std::span<const DecidingMethod> deciding_methods(bool verdicts_only) {
  if (verdicts_only) return methods_for_verdicts;
  return usual_methods;
}

void look_whether_exact(const Problem& problem, const Options& options, Analysis& analysis) {
  const auto open = [](const Verdict& verdict) {
    return verdict.state == VerdictState::holds && !verdict.exact && verdict.bound &&
           verdict.measure != Requirement::Measure::load;
  };
  const auto held =
      static_cast<std::size_t>(std::count_if(analysis.verdicts.begin(), analysis.verdicts.end(), open));
  if (held == 0 || problem.threads.size() > budget::glance_threads) return;
  RunSearchOptions how;
  how.runs = budget::runs_for_held / held;
  if (how.runs < budget::least_runs_for_held) return;
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r) {
    if (open(analysis.verdicts[r]))
      look_for_run(problem, problem.requirements[r], options, how, analysis.verdicts[r]);
  }
}

}  // namespace pal::analyzer
