#include "analyzer/analysis.hpp"

#include <algorithm>
#include <new>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/deciding.hpp"
#include "analyzer/exact/zeno_run.hpp"
#include "analyzer/first_look.hpp"
#include "analyzer/problem/budgets.hpp"
#include "analyzer/verdict/confront.hpp"
#include "analyzer/verdict/loop_growth.hpp"
#include "analyzer/verdict/refuted.hpp"
#include "analyzer/verdict/sentence.hpp"
#include "analyzer/verdict/story.hpp"
#include "analyzer/verdict/taken_as_lost.hpp"
#include "analyzer/verdict/unread.hpp"

namespace pal::analyzer {
namespace {

using State = Verdict::State;

void search_all(const Problem& problem, const Options& options, Analysis& analysis) {
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r)
    search(problem, problem.requirements[r], options, analysis.verdicts[r]);
}

void search_undecided(const Problem& problem, const Options& options, Analysis& analysis) {
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r) {
    if (analysis.verdicts[r].state == State::undecided)
      search(problem, problem.requirements[r], options, analysis.verdicts[r]);
  }
}

/// Decides what is open by what is cheap.
void settle(const Provers& provers, const Problem& problem, const Options& options,
            const std::vector<Verdict>& bounds, Analysis& analysis) {
  const auto is_open = [](const Verdict& verdict) { return verdict.state == State::undecided; };
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r) {
    if (!is_open(analysis.verdicts[r])) continue;
    const auto rest = analysis.verdicts.begin() + static_cast<std::ptrdiff_t>(r);
    const auto left = options.verdicts_only ? std::count_if(rest, analysis.verdicts.end(), is_open)
                                            : analysis.verdicts.end() - rest;
    const auto percent = options.verdicts_only ? budget::share_of_open_for_verdicts : budget::share_of_open;
    decide(deciding_methods(options.verdicts_only), OpenCase{provers, problem, r, bounds, analysis},
           share_of(options, static_cast<double>(percent) / static_cast<double>(left)));
    tell(options, analysis);
  }
}

/// The bounds, each beside the run that is known by now of its requirement.
std::vector<Verdict> confronted(std::vector<Verdict> bounds, const Analysis& known) {
  for (std::size_t r = 0; r < bounds.size(); ++r) {
    bounds[r].witness = known.verdicts[r].witness;
    bounds[r].attained_load = known.verdicts[r].attained_load;
  }
  return bounds;
}

/// Explores, until all runs are seen or the limits are met, the requirements in the state `meant`. If
/// `thorough`: all that are not known exactly by now.
void explore_further(const Provers& provers, const Problem& problem, const Options& options, bool thorough,
                     State meant, const std::vector<Verdict>& bounds, Analysis& known) {
  std::vector<std::size_t> open;
  for (std::size_t r = 0; r < known.verdicts.size(); ++r) {
    const Verdict& verdict = known.verdicts[r];
    if (!verdict.gave_up || verdict.exact || (!thorough && verdict.state != meant)) continue;
    open.push_back(r);
  }
  if (open.empty() || options.max_states <= budget::brief_exploration) return;
  explore(provers, problem, options, open, bounds, known);
}

/// A value that grows in a loop needs no further search.
void say_what_grows(const Problem& problem, const Options& options, Analysis& analysis) {
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r)
    set_loop_growth(problem, problem.requirements[r], options.stop, analysis.verdicts[r]);
}

Analysis analyze_automatically(const Provers& provers, const Problem& problem, const Options& options,
                               bool thorough) {
  Analysis proofs = provers.compositional(problem, share_of(options, budget::share_of_bounds));
  proofs.bounds_only = true;
  tell(options, proofs);
  // Where only verdicts are asked it decides most of them, loads among them, which nothing else does.
  const auto for_all = options.verdicts_only ? budget::share_of_look_for_verdicts : budget::share_of_look;
  Analysis analysis =
      look_at_all(provers, problem, share_of(options, static_cast<double>(for_all)), proofs.verdicts);
  std::vector<Verdict> bounds = confronted(proofs.verdicts, analysis);
  withdraw_refuted(bounds);
  for (std::size_t r = 0; r < bounds.size(); ++r) complete(analysis.verdicts[r], bounds[r]);
  say_ends(problem, share_of(options, budget::share_of_side_looks), analysis);
  tell(options, analysis);
  if (!options.verdicts_only)
    say_what_grows(problem, share_of(options, budget::share_of_side_looks), analysis);
  tell(options, analysis);
  settle(provers, problem, options, bounds, analysis);
  if (options.verdicts_only)
    say_what_grows(problem, share_of(options, budget::share_of_side_looks), analysis);
  share_bounds(problem, analysis);
  if (thorough) {
    search_all(problem, options, analysis);
  } else if (!options.verdicts_only) {
    look_whether_exact(problem, share_of(options, budget::share_of_side_looks), analysis);
  }
  const auto go_on = [&options] { return !(options.stop && options.stop()); };
  if (go_on()) explore_further(provers, problem, options, thorough, State::undecided, bounds, analysis);
  Options failing = options;
  failing.max_states = std::min(options.max_states, budget::most_of_failing);
  if (!thorough && !options.verdicts_only && go_on())
    explore_further(provers, problem, failing, false, State::fails, bounds, analysis);
  // The runs that were found since may contradict bounds, also those that are not used.
  withdraw_refuted(confronted(std::move(bounds), analysis), analysis.verdicts);
  analysis.statistics.seconds += proofs.statistics.seconds;
  analysis.never_lost = proofs.never_lost;
  return analysis;
}

std::vector<Addend> addends_of(const std::vector<Reason>& reasons) {
  std::vector<Addend> addends;
  for (const Reason& each : reasons) {
    if (each.to > each.from)
      addends.push_back(
          {each.to - each.from, each.actor, each.what, each.file, each.line, addends_of(each.inside)});
  }
  return addends;
}

/// Of a bound that a run attains, what happens in that run adds up to it.
void add_up(Verdict& verdict) {
  if (attains(verdict) && !verdict.reasons.empty()) verdict.addends = addends_of(verdict.reasons);
}

Analysis analyze_as(const Provers& provers, const Problem& problem, AnalysisChoice choice,
                    const Options& options) {
  const bool thorough = choice == AnalysisChoice::thorough;
  if (thorough || choice == AnalysisChoice::automatic)
    return analyze_automatically(provers, problem, options, thorough);
  if (choice == AnalysisChoice::half_open) return provers.compositional(problem, options);
  if (choice == AnalysisChoice::compositional) {
    Analysis bounds = provers.compositional(problem, options);
    search_undecided(problem, options, bounds);
    say_what_grows(problem, options, bounds);
    return bounds;
  }
  Analysis analysis = provers.exact(problem, options);
  search_all(problem, options, analysis);
  say_what_grows(problem, options, analysis);
  return analysis;
}

/// A condition that no thread reads is never measured, however few of the runs were seen.
void say_unread(const Problem& problem, Analysis& analysis) {
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r) {
    Verdict& verdict = analysis.verdicts[r];
    if (attained(verdict) || !is_unread(problem, problem.requirements[r])) continue;
    verdict.state = State::never;
    verdict.bound.reset();
    verdict.addends.clear();
    verdict.exact = false;
    verdict.explanation = nothing_measured(problem.requirements[r], true);
  }
}

/// Bounds on the time that passes say nothing where it stands still. What has grown by then, and has no end,
/// is not measured either.
void withhold(Analysis& analysis, const std::string& why) {
  for (Verdict& verdict : analysis.verdicts) {
    const bool grows = verdict.witness && verdict.witness->grows && !verdict.witness->failed;
    if (verdict.state == State::fails && !grows) continue;
    if (grows) verdict.witness.reset();
    verdict.state = State::undecided;
    verdict.bound.reset();
    verdict.addends.clear();
    verdict.exact = false;
    verdict.explanation = why;
  }
}

void withhold_if_time_stands(const ZenoSearch& look, Analysis& analysis) {
  if (look.found)
    withhold(analysis, "a loop goes round for ever at one instant, so nothing is claimed about times");
  if (look.suspected)
    withhold(
        analysis,
        "a loop may go round for ever at one instant: no run shows that, and it could not be excluded, so "
        "nothing is claimed about times");
}

/// Without memory the exploration ends, as at its other limits, and what is known is kept.
Analysis explored_if_there_is_memory(const Problem& problem, const Options& options) {
  try {
    return analyze_exactly(problem, options);
  } catch (const std::bad_alloc&) {
    return nothing_known(problem,
                         "The exploration ended before all runs had been seen: there was no more memory.");
  }
}

/// Puts verdicts that are known beside those of the other requirements.
void join(const std::vector<std::optional<Verdict>>& known, Analysis& analysis) {
  for (std::size_t r = 0; r < known.size(); ++r) {
    if (known[r])
      analysis.verdicts.insert(analysis.verdicts.begin() + static_cast<std::ptrdiff_t>(r), *known[r]);
  }
}

}  // namespace

Analysis nothing_known(const Problem& problem, const std::string& why) {
  Analysis analysis;
  for (const Requirement& requirement : problem.requirements) {
    Verdict& verdict = analysis.verdicts.emplace_back(open_verdict(requirement));
    verdict.gave_up = true;
    verdict.explanation = why;
  }
  return analysis;
}

Analysis analyze(const Problem& problem, AnalysisChoice choice, const Options& options) {
  const Provers provers{
      [](const Problem& of, const Options& how) { return explored_if_there_is_memory(of, how); },
      [half_open = choice == AnalysisChoice::half_open](const Problem& of, const Options& how) {
        return compositional::analyze(of, how, half_open);
      }};
  return analyze_with(provers, problem, choice, options);
}

Analysis analyze_with(const Provers& provers, const Problem& problem, AnalysisChoice choice,
                      const Options& options) {
  tell(options, nothing_known(problem, "The proof ended before anything was known."));
  Problem open = problem;
  open.requirements.clear();
  std::vector<std::optional<Verdict>> by_rows;
  std::vector<std::optional<Verdict>> bounds_by_rows;  // of what is open
  for (const Requirement& requirement : problem.requirements) {
    const bool chooses = choice == AnalysisChoice::automatic || choice == AnalysisChoice::thorough;
    auto shown = chooses ? by_shorter_rows(provers, problem, requirement, options) : std::nullopt;
    const bool holds = shown && shown->state == VerdictState::holds;
    by_rows.push_back(holds ? std::move(shown) : std::nullopt);
    if (holds) continue;
    open.requirements.push_back(requirement);
    bounds_by_rows.push_back(std::move(shown));
  }
  // First in a few classes: when the proofs have used up the time, none of them must hold for want of it.
  ZenoSearch look = find_zeno_run(problem, {std::min(options.max_states, budget::first_look), options.stop});
  Options how = options;
  if (options.known) {
    how.known = [&](const Analysis& known) {
      Analysis all = known;
      join(by_rows, all);
      say_unread(problem, all);
      withhold_if_time_stands(look, all);
      all.bounds_only = all.bounds_only || !look.excluded;
      options.known(all);
    };
  }
  Analysis analysis = analyze_as(provers, open, choice, how);
  for (std::size_t r = 0; r < bounds_by_rows.size(); ++r) {
    if (bounds_by_rows[r]) complete(analysis.verdicts[r], std::move(*bounds_by_rows[r]));
  }
  join(by_rows, analysis);
  say_unread(problem, analysis);
  const bool goes_on =
      !look.found && !look.excluded && !look.suspected && options.max_states > budget::first_look;
  if (goes_on) look = find_zeno_run(problem, {options.max_states, options.stop});
  withhold_if_time_stands(look, analysis);
  analysis.zeno_run = std::move(look.found);
  withdraw_refuted(analysis.verdicts);
  set_taken_as_lost(problem, lost_events(problem, analysis.never_lost, options.stop), analysis.verdicts);
  for (Verdict& verdict : analysis.verdicts) add_up(verdict);
  return analysis;
}

}  // namespace pal::analyzer
