#include "analyzer/exact/exact.hpp"

#include <algorithm>

#include "analyzer/exact/cap.hpp"
#include "analyzer/exact/growth.hpp"
#include "analyzer/load/load.hpp"
#include "analyzer/load/load_account.hpp"
#include "analyzer/machine/loss_rows.hpp"
#include "analyzer/verdict/sentence.hpp"
#include "analyzer/verdict/story.hpp"

namespace pal::analyzer {
namespace {

using Is = Verdict::State;

class Analyzer {
 public:
  Analyzer(const Problem& problem, const Options& options)
      : problem_(problem), options_(options), workers_(options.threads) {}

  Analysis run() {
    memory();
    for (const Requirement& requirement : problem_.requirements) {
      const double begun = now();
      Verdict& verdict = analysis_.verdicts.emplace_back(open_verdict(requirement));
      if (!fits_exploration(problem_)) {
        verdict.explanation = "The skill has too many threads or channels for the exact analysis.";
      } else if (requirement.measure == Requirement::Measure::load) {
        load(requirement, verdict);
      } else if (requirement.measure == Requirement::Measure::busy) {
        busy(requirement, verdict);
      } else {
        timed(requirement, watch_of(problem_, requirement), verdict);
      }
      verdict.statistics.seconds = now() - begun;
      verdict.statistics.peak_memory = memory();
      analysis_.statistics += verdict.statistics;
    }
    return std::move(analysis_);
  }

 private:
  double now() const { return options_.clock ? options_.clock() : 0; }
  std::size_t memory() const { return options_.peak_memory ? options_.peak_memory() : 0; }

  static void count(const ZoneGraph& graph, Verdict& verdict) {
    verdict.statistics.states += graph.places().size();
    verdict.statistics.classes += graph.classes().size();
  }

  Limits limits() { return {options_.max_states, options_.stop, {}, &workers_}; }

  void timed(const Requirement& requirement, const Watch& watch, Verdict& verdict) {
    const Machine machine(problem_, watch);
    Nanoseconds cap = cap_of(problem_, requirement.limit);
    for (int attempt = 0;; ++attempt, cap = std::min(8 * cap, most_cap)) {
      ZoneGraph graph(machine, cap, false);
      const bool complete = graph.explore(limits());
      count(graph, verdict);
      const bool bounded = watch.least && graph.peak().value >= 0;
      const bool beyond = !bounded && (graph.over_cap() || graph.never_answered());
      // A greater cap may find a bound; of what fails already it is asked only where there is likely to be
      // one.
      const bool measured = graph.peak().value >= 0;
      const bool broken =
          (measured && requirement.allowed().broken_by(graph.peak().value)) || graph.growing();
      const bool decided =
          graph.failure() || graph.stuck() >= 0 || (broken && watch.kind != Watch::Kind::age);
      if (complete && beyond && !decided && attempt < 2) continue;
      judge(requirement, machine, graph, complete, cap, verdict);
      return;
    }
  }

  /// Of several processors the one that is busy for longest counts.
  void busy(const Requirement& requirement, Verdict& verdict) {
    Statistics statistics;
    bool first = true;
    bool bounded = true;
    Duration most(0);
    for (const ProcessorId processor : requirement.processors) {
      Verdict each = open_verdict(requirement);
      timed(requirement, watch_of(problem_, requirement, processor), each);
      statistics += each.statistics;
      bounded = bounded && each.bound;
      if (each.bound) most = std::max(most, *each.bound);
      each.explanation = "processor " + problem_.processors[processor].name + ": " + each.explanation;
      if (first || worse(each, verdict)) verdict = std::move(each);
      first = false;
    }
    verdict.statistics = statistics;
    // The worst verdict need not be that of the greatest bound.
    const bool greatest = bounded && *verdict.bound == most;
    if (!greatest) verdict.exact = false;
    if (!greatest) verdict.bound = bounded ? std::optional(most) : std::nullopt;
  }

  static bool worse(const Verdict& a, const Verdict& b) {
    const auto rank = [](Is state) { return state == Is::fails ? 2 : state == Is::undecided ? 1 : 0; };
    if (rank(a.state) != rank(b.state)) return rank(a.state) > rank(b.state);
    return !a.bound || (b.bound && *a.bound > *b.bound);
  }

  void judge(const Requirement& requirement, const Machine& machine, const ZoneGraph& graph, bool complete,
             Nanoseconds cap, Verdict& verdict) {
    if (graph.failure()) return judge_failure(requirement, machine, graph, verdict);
    const bool any = graph.peak().value >= 0;
    if (any) verdict.witness = witness_of(machine, graph, graph.peak(), options_.stop);
    const bool shown = verdict.witness && requirement.allowed().broken_by(verdict.witness->measured.value);
    GrowthSearch grown;
    if (!shown) grown = growth_of(machine, graph, complete, cap);
    verdict.statistics += grown.statistics;
    const bool beyond = graph.over_cap() || (graph.never_answered() && grown.growth != Growth::ends);
    if (!requirement.at_least && grown.growth == Growth::counts)
      show_growth(requirement, machine, graph, std::move(grown.witness), verdict);
    const Peak& certain = graph.findings().certain;
    if (!verdict.witness && certain.value >= 0)
      verdict.witness = witness_of(machine, graph, certain, options_.stop);
    if (verdict.witness) verdict.reasons = reasons(problem_, requirement, *verdict.witness);
    const bool broken = verdict.witness && requirement.allowed().broken_by(verdict.witness->measured.value);
    verdict.gave_up = !complete;
    if (!complete) {
      verdict.state = broken ? Is::fails : Is::undecided;
      return say(requirement, "The exploration ended before all runs had been seen.", verdict);
    }
    if (!any && !beyond && requirement.measure != Requirement::Measure::busy) {
      verdict.state = Is::never;
      verdict.explanation = nothing_measured(requirement, graph.passed());
      return;
    }
    if (beyond && !requirement.at_least) {
      verdict.state = broken ? Is::fails : Is::undecided;
      return say(requirement, "There are longer ones: no bound was found up to " + milliseconds(cap) + ".",
                 verdict);
    }
    const Nanoseconds bound = any                    ? bound_of_row(requirement, graph.peak().value)
                              : requirement.at_least ? cap
                                                     : 0;
    verdict.bound = Duration(bound);
    verdict.exact = (verdict.witness && verdict.witness->measured.value == bound) || (!any && !beyond);
    verdict.state = !requirement.allowed().broken_by(bound) ? Is::holds : broken ? Is::fails : Is::undecided;
    verdict.explanation = explanation(problem_, requirement, verdict);
  }

  /// Of what is open `why` it is so; the run beside it is told by itself, and may yet give way to a worse
  /// one.
  void say(const Requirement& requirement, const std::string& why, Verdict& verdict) const {
    const bool fails = verdict.state == Is::fails;
    verdict.explanation = (fails ? explanation(problem_, requirement, verdict) + ". " : "") + why;
  }

  void judge_failure(const Requirement& requirement, const Machine& machine, const ZoneGraph& graph,
                     Verdict& verdict) {
    verdict.witness = witness_of(machine, graph, unmeasured(*graph.failure()), options_.stop);
    if (verdict.witness && verdict.witness->failed) {
      verdict.state = Is::fails;
      verdict.exact = true;
      verdict.explanation = explanation(problem_, requirement, verdict);
      return;
    }
    verdict.witness.reset();
    verdict.explanation = "an event may stay without a response, but no run was found that shows it";
  }

  /// What becomes of the values that grow beyond the cap.
  GrowthSearch growth_of(const Machine& machine, const ZoneGraph& graph, bool complete, Nanoseconds cap) {
    const bool beyond = graph.over_cap() || graph.never_answered();
    if (!beyond && (complete || !graph.growing())) return {Growth::ends, {}, {}};
    const bool measured = graph.over_cap() && !graph.relaxed();
    if (ends_with_skill(machine) || graph.stuck() >= 0 || measured) return {Growth::counts, {}, {}};
    return growth(problem_, machine.watch(), cap, limits());
  }

  /// A busy period is measured even if it ends with the skill.
  static bool ends_with_skill(const Machine& machine) { return machine.watch().kind == Watch::Kind::busy; }

  /// A run in which the value is over the limit and is measured so in the end, or grows for ever. Of what
  /// grows at first the skill may be over before it counts.
  void show_growth(const Requirement& requirement, const Machine& machine, const ZoneGraph& graph,
                   std::optional<Witness> found, Verdict& verdict) {
    const auto shows = [&] { return found && found->measured.value > requirement.limit; };
    const std::optional<Peak>& beyond = graph.findings().beyond;
    if (!shows() && graph.stuck() >= 0)
      found = stuck_witness(machine, graph, graph.stuck(), requirement.limit + 1);
    if (!shows() && beyond) found = witness_of(machine, graph, *beyond, options_.stop);
    if (!shows() && ends_with_skill(machine) && graph.growing())
      found = witness_of(machine, graph, *graph.growing(), options_.stop);
    if (shows()) verdict.witness = std::move(found);
  }

  static Peak unmeasured(Peak peak) {
    peak.value = -1;
    return peak;
  }

  void load(const Requirement& requirement, Verdict& verdict) {
    const Watch nothing;
    const Machine machine(problem_, nothing);
    ZoneGraph graph(machine, 0, true);
    const bool complete = graph.explore(limits());
    count(graph, verdict);
    verdict.gave_up = !complete;
    if (!complete) {
      verdict.bound = Duration(1'000'000'000);
      verdict.state = requirement.limit >= 1'000'000'000 ? Is::holds : Is::undecided;
      forget_full_load(verdict);
      verdict.explanation = "The exploration ended before all runs had been seen.";
      return;
    }
    if (ends_always(problem_, graph)) {
      verdict.state = Is::never;
      verdict.explanation = nothing_measured(requirement, true);
      return;
    }
    if (options_.verdicts_only && keeps_load(requirement, machine, graph, verdict)) return;
    const std::vector<LoadBound> bounds = load_bounds(machine, graph, requirement.processors, limits());
    std::string others;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      verdict.statistics.classes += bounds[i].states;
      others += (i == 0 ? "" : ", ") + processor_name(requirement.processors[i]) + " " + percent(bounds[i]);
    }
    const auto first = bounds.begin();
    const auto worst = std::max_element(first, bounds.end(),
                                        [](const auto& a, const auto& b) { return greater(b.most, a.most); });
    const auto shown = std::max_element(
        first, bounds.end(), [](const auto& a, const auto& b) { return greater(b.shown, a.shown); });
    const auto processor_of = [&](auto bound) {
      return requirement.processors[static_cast<std::size_t>(bound - first)];
    };
    verdict.bound = Duration(per_second(worst->most));
    if (shown->witness) verdict.attained_load = Duration(per_second(shown->shown));
    verdict.exact = worst->exact;
    verdict.addends = load_account(problem_, processor_of(worst), *worst);
    verdict.witness = worst->exact ? worst->witness : shown->witness;
    verdict.state = *verdict.bound <= verdict.limit                             ? Is::holds
                    : greater(shown->shown, {requirement.limit, 1'000'000'000}) ? Is::fails
                                                                                : Is::undecided;
    verdict.explanation = load_text(*worst, processor_name(processor_of(worst))) + " (" + others + ")";
    if (!worst->exact && shown->witness)
      verdict.explanation +=
          "; a run keeps " + processor_name(processor_of(shown)) + " busy for " + turn_text(shown->shown);
    forget_full_load(verdict);
  }

  /// Whether it is shown that no processor exceeds the limit, by what is cheaper than the least bound.
  bool keeps_load(const Requirement& requirement, const Machine& machine, const ZoneGraph& graph,
                  Verdict& verdict) {
    const Fraction limit{requirement.limit, 1'000'000'000};
    const LoadDecision decision = decide_loads(machine, graph, requirement.processors, limit, limits());
    if (decision.state != Is::holds) return false;
    verdict.bound = Duration(per_second(decision.load));
    verdict.state = Is::holds;
    verdict.explanation =
        "each processor is busy for at most " + percent_text(decision.load) + " of the time in the long run";
    return true;
  }

  /// That a processor is not busy for more than the whole time says nothing of it.
  static void forget_full_load(Verdict& verdict) {
    if (verdict.state != Is::undecided || !verdict.bound || verdict.bound->count() < 1'000'000'000) return;
    verdict.bound.reset();
    verdict.addends.clear();
  }

  const std::string& processor_name(ProcessorId processor) const {
    return problem_.processors[processor].name;
  }

  static std::string turn_text(const Fraction& load) {
    return milliseconds(load.work) + " in every " + milliseconds(load.time) + " in the long run";
  }

  static std::string load_text(const LoadBound& bound, const std::string& processor) {
    if (!bound.proved) return "no bound below full load was proved for processor " + processor;
    return "processor " + processor + " is busy for at most " +
           (bound.exact ? turn_text(bound.most) : percent_text(bound.most) + " of the time in the long run");
  }

  /// Rounded up.
  static std::string percent_text(const Fraction& load) {
    const Nanoseconds hundredths = (per_second(load) + 99'999) / 100'000;
    std::string digits = std::to_string(hundredths % 100);
    if (digits.size() < 2) digits = "0" + digits;
    return std::to_string(hundredths / 100) + "." + digits + " %";
  }

  static std::string percent(const LoadBound& bound) {
    return percent_text(bound.most) + (bound.exact ? "" : bound.proved ? " at most" : " not proved");
  }

  const Problem& problem_;
  const Options& options_;
  Workers workers_;
  Analysis analysis_;
};

}  // namespace

bool every_run_ends(const Problem& problem, const Options& options) {
  if (!fits_exploration(problem)) return false;
  const Watch nothing;
  const Machine machine(problem, nothing);
  ZoneGraph graph(machine, 0, true);
  Workers workers(options.threads);
  return graph.explore({options.max_states, options.stop, {}, &workers}) && ends_always(problem, graph);
}

Analysis analyze_exactly(const Problem& problem, const Options& options) {
  return Analyzer(problem, options).run();
}

}  // namespace pal::analyzer
