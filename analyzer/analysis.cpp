#include "analyzer/analysis.hpp"

#include <algorithm>
#include <new>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/exact/slice_bound.hpp"
#include "analyzer/exact/zeno_run.hpp"
#include "analyzer/machine/loss_rows.hpp"
#include "analyzer/runs/quick_runs.hpp"
#include "analyzer/runs/run_search.hpp"
#include "analyzer/runs/zone_walk.hpp"
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

void tell(const Options& options, const Analysis& analysis) {
  if (options.known) options.known(analysis);
}

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

/// Looks for runs where nothing is decided, and where a bound is not known to be attained.
void search(const Problem& problem, const Requirement& requirement, const Options& options,
            Verdict& verdict) {
  const bool open = verdict.state == State::undecided || (verdict.state == State::holds && !verdict.exact);
  if (!open) return;
  look_for_run(problem, requirement, options, {}, verdict);
  if (verdict.state == State::undecided) look_for_long_run(problem, requirement, options, verdict);
}

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

/// The same of one requirement, for an answer as soon as possible. Most requirements hold while their text is
/// edited, and slices show that; runs that break one are looked for before that only for a moment.
void settle_soon(const Provers& provers, const Problem& problem, const Options& options, std::size_t r,
                 const std::vector<Verdict>& bounds, Analysis& analysis) {
  const auto open = static_cast<double>(
      std::count_if(analysis.verdicts.begin() + static_cast<std::ptrdiff_t>(r), analysis.verdicts.end(),
                    [](const Verdict& verdict) { return verdict.state == State::undecided; }));
  const Options here = share_of(options, 0.8 / open);
  const Requirement& requirement = problem.requirements[r];
  Verdict& verdict = analysis.verdicts[r];
  look_for_long_run(problem, requirement, share_of(here, 0.1), verdict);
  if (verdict.state == State::undecided) explore_slice(problem, requirement, share_of(here, 0.7), verdict);
  if (verdict.state == State::undecided) look_for_run(problem, requirement, share_of(here, 0.3), {}, verdict);
  if (verdict.state == State::undecided) look_by_walks(problem, requirement, share_of(here, 0.5), verdict);
  if (verdict.state == State::undecided && verdict.gave_up) {
    Options brief = here;
    brief.max_states = std::min(options.max_states, brief_exploration);
    explore(provers, problem, brief, {r}, bounds, analysis);
  }
  tell(options, analysis);
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
    if (verdict.state != State::undecided) continue;
    if (options.verdicts_only) {
      settle_soon(provers, problem, options, r, bounds, analysis);
      continue;
    }
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

/// So many classes are explored for all of the requirements together that hold by a bound. A verdict ends the
/// search: in a small skill they show for nothing whether a run attains the bound, and whether there is
/// anything to measure.
constexpr std::size_t most_of_held = 80'000;

/// Less than that shows nothing.
constexpr std::size_t least_of_held = 500;

/// The classes of each requirement that holds by a bound, if so many of them do; 0: it is not explored.
std::size_t glance_at_held(const Problem& problem, std::size_t held) {
  const std::size_t whole = glance(problem);
  const std::size_t share = whole * (most_of_held / brief_exploration) / std::max<std::size_t>(held, 1);
  return share < least_of_held ? 0 : std::min(whole, share);
}

template <class Key, class Value>
bool same(const Table<Key, Value>& one, const Table<Key, Value>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end());
}

/// Whether two requirements measure the same, perhaps with other limits.
bool measure_the_same(const Requirement& one, const Requirement& other) {
  return one.measure == other.measure && one.condition == other.condition && one.samples == other.samples &&
         one.events == other.events && one.device == other.device && same(one.at, other.at) &&
         same(one.phase.after, other.phase.after) && same(one.phase.during, other.phase.during) &&
         one.processors == other.processors && one.in == other.in && one.code == other.code &&
         one.at_least == other.at_least;
}

/// What is proved of a requirement holds for those that measure the same.
void share_bounds(const Problem& problem, Analysis& analysis) {
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r) {
    Verdict& verdict = analysis.verdicts[r];
    if (verdict.state != State::undecided) continue;
    for (std::size_t s = 0; s < analysis.verdicts.size() && verdict.state == State::undecided; ++s) {
      const Verdict& other = analysis.verdicts[s];
      if (s == r || !other.bound || !measure_the_same(problem.requirements[r], problem.requirements[s]))
        continue;
      const bool kept = verdict.at_least ? *other.bound >= verdict.limit : *other.bound <= verdict.limit;
      if (!kept) continue;
      Verdict shared = other;
      shared.requirement = verdict.requirement;
      shared.limit = verdict.limit;
      shared.where = verdict.where;
      shared.state = State::holds;
      shared.statistics = verdict.statistics;
      verdict = std::move(shared);
    }
  }
}

/// Classes of a time where slices, which are smaller, are explored next; fewer once the skill has shown to be
/// larger than that.
constexpr std::size_t brief_look = 15'000;
constexpr std::size_t briefer_look = 3'000;

/// Explores one requirement after the other, loads last, and tells what is known by then: of what has not
/// been looked at only bounds.
void look_at_each(const Provers& provers, const Problem& problem, const Options& options,
                  const std::vector<std::size_t>& which, Analysis& all) {
  Problem part = problem;
  std::size_t most = brief_look;
  std::vector<bool> seen(all.verdicts.size());
  for (const bool loads : {false, true}) {
    for (std::size_t i = 0; i < which.size(); ++i) {
      const Requirement& requirement = problem.requirements[which[i]];
      if ((requirement.measure == Requirement::Measure::load) != loads) continue;
      share_bounds(problem, all);
      Verdict& verdict = all.verdicts[which[i]];
      seen[which[i]] = true;
      if (verdict.state == State::undecided || verdict.method != Method::exact) {
        part.requirements = {requirement};
        Options how = options;
        if (!loads) how.max_states = std::min(how.max_states, most);
        Analysis shown = provers.exact(part, how);
        all.statistics += shown.statistics;
        verdict = std::move(shown.verdicts.front());
        if (!loads && verdict.gave_up) most = briefer_look;
      }
      Analysis now = all;
      for (std::size_t r = 0; r < seen.size(); ++r) {
        if (!seen[r] && now.verdicts[r].state == State::holds) now.verdicts[r].state = State::undecided;
      }
      tell(options, now);
    }
  }
}

/// What a moment's exploration shows of every requirement.
Analysis look_at_all(const Provers& provers, const Problem& problem, const Options& options,
                     const std::vector<Verdict>& bounds) {
  enum class Kind { open, held, settled_load };
  const auto kind_of = [&bounds](std::size_t r) {
    return settled_load(bounds[r])           ? Kind::settled_load
           : bounds[r].state == State::holds ? Kind::held
                                             : Kind::open;
  };
  Analysis all;
  all.verdicts = bounds;
  for (Verdict& verdict : all.verdicts) verdict.gave_up = true;
  for (const Kind kind : {Kind::open, Kind::held, Kind::settled_load}) {
    Problem part = problem;
    part.requirements.clear();
    std::vector<std::size_t> which;
    std::vector<std::pair<std::size_t, std::size_t>> twins;  // of a requirement that measures the same
    for (std::size_t r = 0; r < bounds.size(); ++r) {
      if (kind_of(r) != kind) continue;
      const auto twin = std::find_if(which.begin(), which.end(), [&](std::size_t other) {
        return measure_the_same(problem.requirements[other], problem.requirements[r]);
      });
      if (options.verdicts_only && kind == Kind::held && twin != which.end()) {
        twins.emplace_back(r, *twin);
        continue;
      }
      which.push_back(r);
      part.requirements.push_back(problem.requirements[r]);
    }
    const std::size_t classes = kind == Kind::open   ? glance(problem)
                                : kind == Kind::held ? glance_at_held(problem, which.size())
                                                     : most_of_load;
    if (which.empty() || classes == 0) continue;
    Options how = options;
    how.max_states = std::min(options.max_states, classes);
    if (kind == Kind::open && options.verdicts_only) {
      look_at_each(provers, problem, how, which, all);
      continue;
    }
    Analysis shown = provers.exact(part, how);
    all.statistics += shown.statistics;
    for (std::size_t i = 0; i < which.size(); ++i) all.verdicts[which[i]] = std::move(shown.verdicts[i]);
    // One holds by its own bound; there is something to measure if there is for the other.
    for (const auto& [twin, other] : twins) {
      if (all.verdicts[other].state != State::never) continue;
      all.verdicts[twin].state = State::never;
      all.verdicts[twin].bound.reset();
      all.verdicts[twin].addends.clear();
      all.verdicts[twin].explanation = all.verdicts[other].explanation;
    }
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

/// In rows longer than this, losses are first counted in shorter ones, up to the second.
constexpr int short_row = 8;
constexpr int longest_short_row = 32;

/// A long row of losses consists of short ones, which are explored much sooner. The verdict is what they
/// show: it holds, or is undecided with a bound. Nothing: they show nothing.
std::optional<Verdict> by_shorter_rows(const Provers& provers, const Problem& problem,
                                       const Requirement& requirement, const Options& options) {
  if (requirement.measure != Requirement::Measure::loss || requirement.in <= short_row) return std::nullopt;
  Problem part = problem;
  part.requirements = {requirement};
  Options brief = options;
  brief.max_states = std::min(options.max_states, glance(problem));
  std::vector<std::pair<int, int>> shorter;
  std::optional<Verdict> known;
  for (int row = 1; row <= longest_short_row && row < requirement.in; row *= 2) {
    part.requirements.front().in = row;
    Verdict verdict = provers.exact(part, brief).verdicts.front();
    if (verdict.state == State::never) return std::nullopt;
    if (verdict.gave_up || !verdict.bound) return known;
    const auto lost = static_cast<int>(verdict.bound->count());
    shorter.emplace_back(row, lost);
    const int most = most_lost(requirement.in, shorter);
    if (known && Duration(most) >= *known->bound) continue;
    verdict.state = most <= requirement.limit ? State::holds : State::undecided;
    verdict.limit = Duration(requirement.limit);
    verdict.bound = Duration(most);
    verdict.exact = most == 0;
    if (!verdict.exact) verdict.witness.reset();
    verdict.reasons.clear();
    verdict.explanation = "Of any " + std::to_string(row) + " in a row at most " + std::to_string(lost) +
                          " are lost, so of any " + std::to_string(requirement.in) + " at most " +
                          std::to_string(most) + ".";
    known = std::move(verdict);
    if (known->state == State::holds) break;
  }
  return known;
}

/// So many runs are made for all requirements together that hold by a bound which no run is known to attain:
/// in a small skill they show for nothing that it is exact.
constexpr std::size_t runs_for_held = 400;
constexpr std::size_t least_runs_for_held = 40;  // of each
constexpr std::size_t few_threads_for_held = 16;

void look_whether_exact(const Problem& problem, const Options& options, Analysis& analysis) {
  const auto open = [](const Verdict& verdict) {
    return verdict.state == State::holds && !verdict.exact && verdict.bound &&
           verdict.measure != Requirement::Measure::load;
  };
  const auto held =
      static_cast<std::size_t>(std::count_if(analysis.verdicts.begin(), analysis.verdicts.end(), open));
  if (held == 0 || problem.threads.size() > few_threads_for_held) return;
  RunSearchOptions how;
  how.runs = runs_for_held / held;
  if (how.runs < least_runs_for_held) return;
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r) {
    if (open(analysis.verdicts[r]))
      look_for_run(problem, problem.requirements[r], options, how, analysis.verdicts[r]);
  }
}

/// A value that grows in a loop needs no further search.
void say_what_grows(const Problem& problem, const Options& options, Analysis& analysis) {
  for (std::size_t r = 0; r < analysis.verdicts.size(); ++r)
    set_loop_growth(problem, problem.requirements[r], options.stop, analysis.verdicts[r]);
}

Analysis analyze_automatically(const Provers& provers, const Problem& problem, const Options& options,
                               bool thorough) {
  Analysis proofs = provers.compositional(problem, share_of(options, 0.6));
  proofs.bounds_only = true;
  tell(options, proofs);
  // Where only verdicts are asked it decides most of them, loads among them, which nothing else does.
  const double for_all = options.verdicts_only ? 0.6 : 0.2;
  Analysis analysis = look_at_all(provers, problem, share_of(options, for_all), proofs.verdicts);
  std::vector<Verdict> bounds = confronted(proofs.verdicts, analysis);
  withdraw_refuted(bounds);
  for (std::size_t r = 0; r < bounds.size(); ++r) complete(analysis.verdicts[r], bounds[r]);
  say_ends(problem, share_of(options, 0.2), analysis);
  tell(options, analysis);
  if (!options.verdicts_only) say_what_grows(problem, share_of(options, 0.2), analysis);
  tell(options, analysis);
  settle(provers, problem, options, bounds, analysis);
  if (options.verdicts_only) say_what_grows(problem, share_of(options, 0.2), analysis);
  share_bounds(problem, analysis);
  if (thorough) {
    search_all(problem, options, analysis);
  } else if (!options.verdicts_only) {
    look_whether_exact(problem, share_of(options, 0.2), analysis);
  }
  const auto go_on = [&options] { return !(options.stop && options.stop()); };
  if (go_on()) explore_further(provers, problem, options, thorough, State::undecided, bounds, analysis);
  Options failing = options;
  failing.max_states = std::min(options.max_states, most_of_failing);
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
    Verdict& verdict = analysis.verdicts.emplace_back();
    verdict.requirement = requirement.name;
    verdict.measure = requirement.measure;
    verdict.limit = Duration(requirement.limit);
    verdict.at_least = requirement.at_least;
    verdict.where = requirement.where;
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
  ZenoSearch look = find_zeno_run(problem, {std::min(options.max_states, first_look), options.stop});
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
  const bool goes_on = !look.found && !look.excluded && !look.suspected && options.max_states > first_look;
  if (goes_on) look = find_zeno_run(problem, {options.max_states, options.stop});
  withhold_if_time_stands(look, analysis);
  analysis.zeno_run = std::move(look.found);
  withdraw_refuted(analysis.verdicts);
  set_taken_as_lost(problem, lost_events(problem, analysis.never_lost, options.stop), analysis.verdicts);
  for (Verdict& verdict : analysis.verdicts) add_up(verdict);
  return analysis;
}

}  // namespace pal::analyzer
