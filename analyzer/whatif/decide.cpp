#include "analyzer/whatif/decide.hpp"

#include <algorithm>

#include "analyzer/exact/zeno_run.hpp"
#include "analyzer/load/load.hpp"
#include "analyzer/runs/quick_runs.hpp"
#include "analyzer/verdict/unread.hpp"

namespace pal::analyzer {
namespace {

using Measure = Requirement::Measure;
using Is = Verdict::State;

/// Where more is to be done than there is time a skill has mostly too many classes to be explored, unless it
/// ends soon.
constexpr std::size_t overloaded_classes = 20'000;

/// Requirements that one watch decides, and for which growing beyond the limit is failing.
bool has_cap(const Requirement& requirement) {
  const bool timed = requirement.measure == Measure::age || requirement.measure == Measure::response ||
                     requirement.measure == Measure::reaction || requirement.measure == Measure::duration;
  return timed && !requirement.at_least;
}

/// Whether the flow of `thread` leads to one of the steps `at`.
bool comes_to(const Problem& problem, const Thread& thread, const std::vector<bool>& at) {
  if (at.empty()) return false;
  std::vector<bool> seen(problem.steps.size());
  std::vector<int> open{thread.entry};
  while (!open.empty()) {
    const auto here = static_cast<std::size_t>(open.back());
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
  const auto overloaded = [&problem](int processor) {
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
  if (witness.failed) return true;
  const Nanoseconds value = witness.measured.value;
  return requirement.at_least ? value < requirement.limit : value > requirement.limit;
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
      auto made = witness_of(machine_, graph, peak, quick, stop_);
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

Decision by_analysis(const Problem& problem, std::size_t requirement, const Options& options) {
  Problem alone = problem;
  alone.requirements = {problem.requirements[requirement]};
  Verdict verdict = std::move(analyze_exactly(alone, options).verdicts.front());
  const bool fails = verdict.state == Is::fails;
  const bool grows = verdict.witness && verdict.witness->grows && !verdict.witness->failed;
  return {verdict.state == Is::never ? Is::holds : verdict.state,
          fails && one_run(problem.requirements[requirement]) ? std::move(verdict.witness) : std::nullopt,
          {},
          fails && grows};
}

Decision load_decision(const Problem& problem, std::size_t index, const Options& options, Workers& workers) {
  const Watch nothing;
  const Machine machine(problem, nothing);
  ZoneGraph graph(machine, 0, true);
  const Limits limits{options.max_states, options.stop, {}, &workers};
  if (!graph.explore(limits)) return {};
  const Requirement& requirement = problem.requirements[index];
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

Decision decide_by_time(const Problem& problem, std::size_t index, const Verdict& bound,
                        const Options& options, Workers& workers) {
  const Requirement& requirement = problem.requirements[index];
  if (is_unread(problem, requirement)) return {Is::holds, {}, {}};
  if (bound.state == Is::holds) return held_by(requirement, bound);
  if (!fits_exploration(problem)) return {};
  if (requirement.measure == Measure::load) return load_decision(problem, index, options, workers);
  const Break simulated = simulated_break(problem, requirement, options.stop);
  if (simulated != Break::none) return {Is::fails, {}, {}, simulated == Break::grown};
  if (!has_cap(requirement)) return by_analysis(problem, index, options);
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
  return by_analysis(problem, index, options);  // what is over the limit may not be possible
}

}  // namespace

Decision decide(const Problem& problem, std::size_t index, const Verdict& bound, const Options& given,
                Workers& workers) {
  Options options = given;
  if (is_overloaded(problem, problem.requirements[index]))
    options.max_states = std::min(given.max_states, overloaded_classes);
  Decision decision = decide_by_time(problem, index, bound, options, workers);
  const Limits limits{options.max_states, options.stop, {}, &workers};
  // Where time stands still nothing holds, and what has no end by then is not measured.
  const bool of_all_time = decision.state == Is::holds || decision.grows;
  if (of_all_time && find_zeno_run(problem, limits).found) return {};
  return decision;
}

bool refutes(const Problem& problem, std::size_t index, const Witness& witness,
             const std::function<bool()>& stop) {
  const Requirement& requirement = problem.requirements[index];
  if (!one_run(requirement) || witness.grows || witness.script.empty()) return false;
  const Watch watch = watch_of(problem, requirement);
  const Machine machine(problem, watch);
  const auto made = witness_along(machine, witness.script, !witness.failed, -1, true, stop);
  return made && broken(requirement, *made);
}

}  // namespace pal::analyzer
