#include "analyzer/analysis.hpp"

#include <algorithm>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/exact/slice_bound.hpp"
#include "analyzer/exact/zeno_run.hpp"
#include "analyzer/runs/quick_runs.hpp"
#include "analyzer/runs/run_search.hpp"
#include "analyzer/runs/zone_walk.hpp"
#include "analyzer/verdict/confront.hpp"
#include "analyzer/verdict/refuted.hpp"
#include "analyzer/verdict/sentence.hpp"
#include "analyzer/verdict/story.hpp"
#include "analyzer/verdict/unread.hpp"

namespace pal::analyzer {
namespace {

using State = Verdict::State;

/// So many classes are explored before what leaves out parts of the skill is tried.
constexpr std::size_t brief_exploration = 20'000;

/// So many classes are explored in a moment, also where a bound says enough. A class of a skill with many
/// threads takes longer, about with their square.
std::size_t glance(const Problem& problem) {
  constexpr std::size_t few_threads = 16;
  constexpr std::size_t least = 1'000;
  const std::size_t threads = std::max(problem.threads.size(), few_threads);
  return std::max(least, brief_exploration * few_threads * few_threads / (threads * threads));
}

/// So many classes show most loops in which no time passes.
constexpr std::size_t first_look = 5'000;

/// What the compositional analysis adds to an exact verdict.
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
  bound.attained_load = verdict.attained_load;
  bound.explanation += " The exact analysis: " + verdict.explanation;
  bound.statistics += verdict.statistics;
  bound.gave_up = verdict.gave_up;
  bound.exact = attains(bound);
  verdict = std::move(bound);
}

/// Until a part of the time that is left is over.
Options share_of(const Options& options, double part) {
  if (!options.deadline || !options.clock) return options;
  Options shared = options;
  const double now = options.clock();
  const double end = now + std::max(0.0, *options.deadline - now) * part;
  shared.deadline = end;
  shared.stop = [stop = options.stop, clock = options.clock, end] {
    return (stop && stop()) || clock() > end;
  };
  return shared;
}

/// Looks for a run that attains the bound, or breaks the requirement.
void look_for_run(const Problem& problem, const Requirement& requirement, const Options& options,
                  const RunSearchOptions& usual, Verdict& verdict) {
  RunSearchOptions how = usual;
  how.stop = options.stop;
  how.steady = verdict.state == State::undecided ? 64 : 0;
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

/// So many steps of walks take less time than a class: nothing is compared.
constexpr std::size_t walked_per_class = 3;

/// What has to meet within a short time is seldom met by times that are drawn.
void look_by_walks(const Problem& problem, const Requirement& requirement, const Options& options,
                   Verdict& verdict) {
  ZoneWalkOptions how;
  how.steps = std::min(walked_per_class * glance(problem), options.max_states);
  how.stop = options.stop;
  auto found = walk_zones(problem, requirement, how);
  if (found) confront(problem, requirement, std::move(*found), verdict);
}

/// Looks for runs where a bound is not known to be attained.
void search(const Problem& problem, const Requirement& requirement, const Options& options,
            Verdict& verdict) {
  const bool open = verdict.state == State::undecided || (verdict.state == State::holds && !verdict.exact);
  if (!open) return;
  look_for_run(problem, requirement, options, {}, verdict);
  if (verdict.state == State::undecided) look_for_long_run(problem, requirement, options, verdict);
}

/// What is decided is only attacked by a few runs.
void attack(const Problem& problem, const Requirement& requirement, const Options& options,
            Verdict& verdict) {
  if (verdict.state != State::holds || verdict.exact) return;
  RunSearchOptions few;
  few.runs = few.drawn;
  look_for_run(problem, requirement, options, few, verdict);
}

void search_all(const Problem& problem, const Options& options, Analysis& analysis) {
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r)
    search(problem, problem.requirements[r], options, analysis.verdicts[r]);
}

/// So many classes of slices are explored, whatever the limit.
constexpr std::size_t most_of_slice = 400'000;

/// What is shown by leaving out what has no say, and what it took.
Statistics explore_slice(const Problem& problem, const Requirement& requirement, const Options& options,
                         Verdict& verdict) {
  using Measure = Requirement::Measure;
  const bool timed = requirement.measure != Measure::load && requirement.measure != Measure::busy;
  if (!timed || !fits_exploration(problem)) return {};
  const SliceBound found =
      slice_bound(problem, requirement, options, std::min(options.max_states, most_of_slice));
  verdict.statistics += found.statistics;
  if (!found.bound) return found.statistics;
  const Duration bound(*found.bound);
  if (verdict.bound && (verdict.at_least ? *verdict.bound >= bound : *verdict.bound <= bound))
    return found.statistics;
  verdict.method = Method::exact;
  verdict.bound = bound;
  verdict.addends.clear();
  verdict.exact = attains(verdict);
  const bool within = verdict.at_least ? bound >= verdict.limit : bound <= verdict.limit;
  if (within) verdict.state = State::holds;
  verdict.explanation =
      verdict.exact
          ? explanation(problem, requirement, verdict)
          : "Found by exploring only what has an influence; no run exceeds it, but none is known to "
            "attain it.";
  return found.statistics;
}

/// Explores the requirements `open`, and puts what is found in the place of what is known by now if it says
/// more.
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
    const bool refuted = now.state == State::fails && before.state != State::fails;
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

/// Decides what is open by what is cheap: first by runs, as pal simulate makes them.
void settle(const Provers& provers, const Problem& problem, const Options& options,
            const std::vector<Verdict>& bounds, Analysis& analysis) {
  Options brief = options;
  brief.max_states = std::min(options.max_states, brief_exploration);
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r) {
    const double part = 0.5 / static_cast<double>(analysis.verdicts.size() - r);
    const Options here = share_of(options, part);
    const Requirement& requirement = problem.requirements[r];
    Verdict& verdict = analysis.verdicts[r];
    attack(problem, requirement, here, verdict);
    if (verdict.state != State::undecided) continue;
    look_for_long_run(problem, requirement, share_of(here, 0.25), verdict);
    const bool more = verdict.gave_up && brief.max_states > glance(problem);
    if (verdict.state == State::undecided && more) {
      Options first = share_of(here, 0.3);
      first.max_states = brief.max_states;
      explore(provers, problem, first, {r}, bounds, analysis);
    }
    if (verdict.state == State::undecided)
      look_for_run(problem, requirement, share_of(here, 0.3), {}, verdict);
    if (verdict.state == State::undecided) look_by_walks(problem, requirement, share_of(here, 0.3), verdict);
    if (verdict.state == State::undecided) explore_slice(problem, requirement, share_of(here, 0.6), verdict);
    // Also of a bound that decides: the run that comes near it is shown.
    if (verdict.state != State::undecided) search(problem, requirement, here, verdict);
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

/// So many classes are explored to see how far what fails can go.
constexpr std::size_t most_of_failing = 200'000;

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
  if (open.empty() || options.max_states <= brief_exploration) return;
  explore(provers, problem, options, open, bounds, known);
}

/// Of more classes a load that a bound has settled is not looked at: it takes much longer than a time.
constexpr std::size_t most_of_load = 1'000;

/// Whether a bound settles a load.
bool settled_load(const Verdict& bound) {
  return bound.measure == Requirement::Measure::load && bound.state == State::holds;
}

/// What a moment's exploration shows of every requirement.
Analysis look_at_all(const Provers& provers, const Problem& problem, const Options& options,
                     const std::vector<Verdict>& bounds) {
  Analysis all;
  all.verdicts.resize(bounds.size());
  for (const bool load : {false, true}) {
    Options how = options;
    how.max_states = std::min(options.max_states, load ? most_of_load : glance(problem));
    Problem part = problem;
    part.requirements.clear();
    std::vector<std::size_t> which;
    for (std::size_t r = 0; r < bounds.size(); ++r) {
      if (settled_load(bounds[r]) != load) continue;
      which.push_back(r);
      part.requirements.push_back(problem.requirements[r]);
    }
    if (which.empty()) continue;
    Analysis shown = provers.exact(part, how);
    all.statistics += shown.statistics;
    for (std::size_t i = 0; i < which.size(); ++i) all.verdicts[which[i]] = std::move(shown.verdicts[i]);
  }
  return all;
}

/// A bound settles no load of the long run if there is none.
void say_ends(const Problem& problem, const Options& options, Analysis& analysis) {
  const auto open = [](const Verdict& verdict) { return settled_load(verdict) && verdict.gave_up; };
  if (std::none_of(analysis.verdicts.begin(), analysis.verdicts.end(), open)) return;
  Options brief = options;
  brief.max_states = std::min(options.max_states, glance(problem));
  if (!every_run_ends(problem, brief)) return;
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r) {
    Verdict& verdict = analysis.verdicts[r];
    if (!open(verdict)) continue;
    verdict.state = State::never;
    verdict.bound.reset();
    verdict.addends.clear();
    verdict.explanation = nothing_measured(problem.requirements[r], true);
  }
}

Analysis analyze_automatically(const Provers& provers, const Problem& problem, const Options& options,
                               bool thorough) {
  const Analysis proofs = provers.compositional(problem, share_of(options, 0.6));
  Analysis analysis = look_at_all(provers, problem, share_of(options, 0.2), proofs.verdicts);
  std::vector<Verdict> bounds = confronted(proofs.verdicts, analysis);
  withdraw_refuted(bounds);
  for (std::size_t r = 0; r < bounds.size(); ++r) complete(analysis.verdicts[r], bounds[r]);
  say_ends(problem, share_of(options, 0.2), analysis);
  settle(provers, problem, options, bounds, analysis);
  if (thorough) search_all(problem, options, analysis);
  const auto go_on = [&options] { return !(options.stop && options.stop()); };
  if (go_on()) explore_further(provers, problem, options, thorough, State::undecided, bounds, analysis);
  Options failing = options;
  failing.max_states = std::min(options.max_states, most_of_failing);
  if (!thorough && go_on()) explore_further(provers, problem, failing, false, State::fails, bounds, analysis);
  // The runs that were found since may contradict bounds, also those that are not used.
  withdraw_refuted(confronted(std::move(bounds), analysis), analysis.verdicts);
  analysis.statistics.seconds += proofs.statistics.seconds;
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
  Analysis analysis = choice == AnalysisChoice::exact ? provers.exact(problem, options)
                                                      : provers.compositional(problem, options);
  search_all(problem, options, analysis);
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
void withhold(Analysis& analysis) {
  for (Verdict& verdict : analysis.verdicts) {
    const bool grows = verdict.witness && verdict.witness->grows && !verdict.witness->failed;
    if (verdict.state == State::fails && !grows) continue;
    if (grows) verdict.witness.reset();
    verdict.state = State::undecided;
    verdict.bound.reset();
    verdict.addends.clear();
    verdict.exact = false;
    verdict.explanation = "a loop goes round for ever at one instant, so nothing is claimed about times";
  }
}

}  // namespace

Analysis analyze(const Problem& problem, AnalysisChoice choice, const Options& options) {
  const Provers provers{
      [](const Problem& of, const Options& how) { return analyze_exactly(of, how); },
      [](const Problem& of, const Options& how) { return compositional::analyze(of, how); }};
  return analyze_with(provers, problem, choice, options);
}

Analysis analyze_with(const Provers& provers, const Problem& problem, AnalysisChoice choice,
                      const Options& options) {
  // First in a few classes: when the proofs have used up the time, none of them must hold for want of it.
  ZenoSearch look = find_zeno_run(problem, {std::min(options.max_states, first_look), options.stop});
  Analysis analysis = analyze_as(provers, problem, choice, options);
  say_unread(problem, analysis);
  const bool goes_on = !look.found && !look.excluded && options.max_states > first_look;
  if (goes_on) look = find_zeno_run(problem, {options.max_states, options.stop});
  analysis.zeno_run = std::move(look.found);
  if (analysis.zeno_run) withhold(analysis);
  withdraw_refuted(analysis.verdicts);
  for (Verdict& verdict : analysis.verdicts) add_up(verdict);
  return analysis;
}

}  // namespace pal::analyzer
