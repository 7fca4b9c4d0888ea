#include "analyzer/whatif/decide.hpp"

#include <algorithm>
#include <cassert>

#include "analyzer/exact/slice_bound.hpp"
#include "analyzer/load/load.hpp"
#include "analyzer/problem/budgets.hpp"
#include "analyzer/runs/quick_runs.hpp"
#include "analyzer/runs/run_search.hpp"
#include "analyzer/verdict/unread.hpp"

namespace pal::analyzer::whatif {
namespace {

using Measure = Requirement::Measure;
using Is = Verdict::State;

/// Requirements that one watch decides, and for which growing beyond the limit is failing.
bool has_cap(const Requirement& requirement) {
  const bool timed = requirement.measure == Measure::age || requirement.measure == Measure::response ||
                     requirement.measure == Measure::reaction || requirement.measure == Measure::duration;
  return timed && !requirement.at_least;
}

/// Whether the flow of `thread` leads to one of the steps `at`.
bool comes_to(const Problem& problem, const Thread& thread, const Table<StepId, bool>& at) {
  if (at.empty()) return false;
  Table<StepId, bool> seen(problem.steps.size());
  std::vector<StepId> open{thread.entry};
  while (!open.empty()) {
    const StepId here = open.back();
    open.pop_back();
    if (seen[here]) continue;
    if (at[here]) return true;
    seen[here] = true;
    open.insert(open.end(), problem.steps[here].next.begin(), problem.steps[here].next.end());
  }
  return false;
}

/// Whether it is of a processor that has more to do than there is time, or of statements that run there.
bool is_overloaded(const Problem& problem, const Requirement& requirement) {
  const auto overloaded = [&problem](ProcessorId processor) {
    return std::find(problem.overloaded.begin(), problem.overloaded.end(), processor) !=
           problem.overloaded.end();
  };
  if (std::any_of(requirement.processors.begin(), requirement.processors.end(), overloaded)) return true;
  return std::any_of(problem.threads.begin(), problem.threads.end(), [&](const Thread& thread) {
    return overloaded(thread.processor) && comes_to(problem, thread, requirement.at);
  });
}

/// Whether one run can be played again with other figures, and break it again.
bool one_run(const Requirement& requirement) {
  return requirement.measure != Measure::load && requirement.measure != Measure::busy;
}

bool broken(const Requirement& requirement, const Witness& witness) {
  return witness.failed || requirement.allowed().broken_by(witness.measured.value);
}

/// Looks at what an exploration found so far for a run that breaks the requirement.
class Search {
 public:
  Search(const Requirement& requirement, const Machine& machine, const std::function<bool()>& stop)
      : requirement_(requirement), machine_(machine), stop_(stop) {}

  bool found(const ZoneGraph& graph) {
    const Findings& findings = graph.findings();
    if (findings.failure) attempt(graph, unmeasured(*findings.failure), failure_tried_);
    if (findings.beyond) attempt(graph, *findings.beyond, beyond_tried_);
    for (const Peak* peak : {&findings.certain, &findings.peak}) {
      if (peak->value <= std::max(requirement_.limit, tried_)) continue;
      tried_ = peak->value;
      bool once = false;
      attempt(graph, *peak, once);
    }
    return witness.has_value();
  }

  std::optional<Witness> witness;

 private:
  static Peak unmeasured(Peak peak) {
    peak.value = -1;
    return peak;
  }

  void attempt(const ZoneGraph& graph, const Peak& peak, bool& tried) {
    if (witness || tried) return;
    tried = true;
    for (const bool quick : {true, false}) {
      auto made = breaking_witness_of(machine_, graph, peak, requirement_.limit, quick, stop_);
      if (made && broken(requirement_, *made)) witness = std::move(made);
      if (witness) return;
    }
  }

  const Requirement& requirement_;
  const Machine& machine_;
  const std::function<bool()>& stop_;
  bool failure_tried_ = false;
  bool beyond_tried_ = false;
  Nanoseconds tried_ = -1;
};

Decision by_analysis(const Problem& problem, const Requirement& requirement, const Options& options) {
  Problem alone = problem;
  alone.requirements = {requirement};
  Verdict verdict = std::move(analyze_exactly(alone, options).verdicts.front());
  const bool fails = verdict.state == Is::fails;
  const bool grows = verdict.witness && verdict.witness->grows && !verdict.witness->failed;
  return {verdict.state == Is::never ? Is::holds : verdict.state,
          fails && one_run(requirement) ? std::move(verdict.witness) : std::nullopt,
          {},
          fails && grows};
}

Decision load_decision(const Problem& problem, const Requirement& requirement, const Options& options,
                       Workers& workers) {
  const Watch nothing;
  const Machine machine(problem, nothing);
  ZoneGraph graph(machine, 0, true);
  const Limits limits{options.max_states, options.stop, {}, &workers};
  if (!graph.explore(limits)) return {};
  const Fraction limit{requirement.limit, 1'000'000'000};
  const LoadDecision decision = decide_loads(machine, graph, requirement.processors, limit, limits);
  if (decision.state == Is::undecided) return {};
  return {decision.state, std::nullopt, per_second(decision.load) - requirement.limit};
}

Decision held_by(const Requirement& requirement, const Verdict& bound) {
  Decision decision{Is::holds, {}, {}};
  if (requirement.measure == Measure::load && bound.bound)
    decision.excess = bound.bound->count() - requirement.limit;
  return decision;
}

/// By one run that was found, if it breaks the requirement.
Decision decision_of(const Requirement& requirement, std::optional<Witness> found) {
  if (!found || found->grows || !broken(requirement, *found)) return {};
  return {Is::fails, std::move(found), {}, false};
}

Decision by_search(const Problem& problem, const Requirement& requirement, std::size_t runs,
                   const std::function<bool()>& stop) {
  RunSearchOptions how;
  how.runs = runs;
  how.stop = stop;
  return decision_of(requirement, search_runs(problem, requirement, how));
}

const Requirement& requirement_of(const Problem& problem, RequirementId id) {
  assert(id.valid() && id.index() < problem.requirements.size());
  return problem.requirements[id.index()];
}

/// How many of the allowed classes are explored. It is fewer where there is more to do than there is time,
/// because such an exploration mostly has no end.
std::size_t classes_for(const AskedCase& open, std::size_t allowed) {
  const bool overloaded = is_overloaded(open.problem, requirement_of(open.problem, open.requirement));
  return overloaded ? std::min(allowed, budget::overloaded_classes) : allowed;
}

/// By its compositional bound.
void by_bound(const AskedCase& open, const Options&) {
  const Requirement& requirement = requirement_of(open.problem, open.requirement);
  if (is_unread(open.problem, requirement)) {
    open.decision = {Is::holds, {}, {}};
  } else if (open.bound.state == Is::holds) {
    open.decision = held_by(requirement, open.bound);
  }
}

/// By a few single runs with worst times: some milliseconds.
void by_worst_runs(const AskedCase& open, const Options& options) {
  const Problem& problem = open.problem;
  const Requirement& requirement = requirement_of(problem, open.requirement);
  if (requirement.measure == Measure::loss) {
    open.decision = by_search(problem, requirement, budget::few_runs_for_loss, options.stop);
    return;
  }
  const Break simulated = simulated_break(problem, requirement, options.stop);
  if (simulated == Break::none) return;
  open.decision = {Is::fails, {}, {}, simulated == Break::grown};
  // The run is kept. One that is overloaded is too long to be played again.
  if (simulated == Break::measured && one_run(requirement) && problem.overloaded.empty())
    open.decision.witness = decision_of(requirement, simulated_witness(problem, requirement, options.stop,
                                                                       budget::events_of_witness))
                                .witness;
}

/// By exploring what has an influence (slice_bound.hpp).
void by_slice(const AskedCase& open, const Options& options) {
  const Requirement& requirement = requirement_of(open.problem, open.requirement);
  if (!one_run(requirement) || !fits_exploration(open.problem)) return;
  Options here = options;
  here.max_states = classes_for(open, options.max_states);
  const SliceBound found = slice_bound(open.problem, requirement, here, here.max_states);
  if (found.bound && !requirement.allowed().broken_by(*found.bound)) open.decision = {Is::holds, {}, {}};
}

void by_long_run(const AskedCase& open, const Options& options) {
  const Requirement& requirement = requirement_of(open.problem, open.requirement);
  if (one_run(requirement))
    open.decision = decision_of(requirement, simulated_witness(open.problem, requirement, options.stop,
                                                               events_for(options.max_states)));
}

void by_runs(const AskedCase& open, const Options& options) {
  const Requirement& requirement = requirement_of(open.problem, open.requirement);
  if (one_run(requirement))
    open.decision = by_search(open.problem, requirement, budget::many_runs_for_what_if, options.stop);
}

/// By exploring all runs, in at most so many classes. Values are followed up to the limit only, and the
/// exploration ends with the first run that is confirmed to exceed it.
Decision explored(const Problem& problem, const Requirement& requirement, const Options& options,
                  Workers& workers) {
  if (!fits_exploration(problem)) return {};
  if (requirement.measure == Measure::load) return load_decision(problem, requirement, options, workers);
  if (!has_cap(requirement)) return by_analysis(problem, requirement, options);
  const Watch watch = watch_of(problem, requirement);
  const Machine machine(problem, watch);
  Search search(requirement, machine, options.stop);
  ZoneGraph graph(machine, requirement.limit, false);
  const bool complete =
      graph.explore({options.max_states, options.stop,
                     [&](const ZoneGraph& so_far) { return search.found(so_far); }, &workers});
  if (search.found(graph)) {
    const bool grows = search.witness->grows && !search.witness->failed;
    return {Is::fails, std::move(search.witness), {}, grows};
  }
  const Findings& findings = graph.findings();
  const bool clean = !findings.failure && !findings.over_cap && !findings.never_answered &&
                     findings.peak.value <= requirement.limit;
  if (complete && clean) return {Is::holds, {}, {}};
  if (!complete) return {};
  return by_analysis(problem, requirement, options);  // what is over the limit may not be possible
}

/// If it was not explored as far as that before.
void by_exploration(const AskedCase& open, const Options& given) {
  Options options = given;
  options.max_states = classes_for(open, given.max_states);
  if (options.max_states <= open.explored) return;
  open.explored = options.max_states;
  open.decision =
      explored(open.problem, requirement_of(open.problem, open.requirement), options, open.workers);
}

void by_brief_exploration(const AskedCase& open, const Options& given) {
  Options options = given;
  options.max_states = std::min(given.max_states, budget::few_classes);
  by_exploration(open, options);
}

constexpr AskingMethod at_once[] = {{"bound", true, false, 100, by_bound},
                                    {"runs with worst times", false, true, 100, by_worst_runs}};
constexpr AskingMethod in_a_moment[] = {{"exploration in a moment", true, true, 100, by_brief_exploration}};
constexpr AskingMethod by_parts[] = {{"slice", true, false, 100, by_slice},
                                     {"long run", false, true, 100, by_long_run},
                                     {"single runs", false, true, 100, by_runs}};
constexpr AskingMethod at_last[] = {{"exploration", true, true, 100, by_exploration}};
constexpr AskingRound rounds[] = {
    {at_once, 0}, {in_a_moment, 1}, {by_parts, budget::few_classes + 1}, {at_last, budget::few_classes + 1}};

}  // namespace

std::span<const AskingRound> asking_rounds() {
  return rounds;
}

bool refutes(const Problem& problem, RequirementId id, const Witness& witness,
             const std::function<bool()>& stop) {
  const Requirement& requirement = requirement_of(problem, id);
  if (!one_run(requirement) || witness.grows || witness.script.empty()) return false;
  const Watch watch = watch_of(problem, requirement);
  const Machine machine(problem, watch);
  WitnessSearch search;
  search.measured = !witness.failed;
  search.quick = true;
  search.stop = stop;
  const auto made = witness_along(machine, witness.script, search);
  return made && broken(requirement, *made);
}

}  // namespace pal::analyzer::whatif
