#include "analyzer/compositional/compositional.hpp"

#include <algorithm>

#include "analyzer/compositional/breakdown.hpp"
#include "analyzer/compositional/causes/cloned_blocks.hpp"
#include "analyzer/compositional/measures/measures.hpp"

namespace pal::analyzer::compositional {
namespace {

using namespace compositional;
using Is = Verdict::State;
using Measure = Requirement::Measure;

Bound bound_of(const View& view, const Requirement& requirement) {
  switch (requirement.measure) {
    case Measure::age:
      return age_bound(view, requirement);
    case Measure::response:
      return response_bound(view, requirement);
    case Measure::load:
      return load_bound(view, requirement);
    case Measure::busy:
      return busy_bound(view, requirement);
    case Measure::loss:
      return loss_bound(view, requirement);
    case Measure::reaction:
      return reaction_bound(view, requirement);
    case Measure::interval:
      return interval_bound(view, requirement);
    case Measure::duration:
      return duration_bound(view, requirement);
  }
  return {};
}

/// That a processor is not busy for more than the whole time says nothing of it.
bool says_nothing(const Bound& bound, const Verdict& verdict) {
  constexpr Nanoseconds second = 1'000'000'000;
  return verdict.measure == Measure::load && bound.sum.value() >= second && verdict.limit.count() < second;
}

void judge(const Bound& bound, const Requirement& requirement, bool half_open, Verdict& verdict) {
  if (!bound.known() || says_nothing(bound, verdict)) {
    verdict.explanation = "The compositional analysis has no bound: " + bound.why.text + ".";
    return;
  }
  verdict.bound = Duration(bound.sum.value());
  verdict.state = verdict.allowed().broken_by(*verdict.bound) ? Is::undecided : Is::holds;
  verdict.explanation = std::string("Compositional bound: no run ") +
                        (verdict.at_least ? "falls below" : "exceeds") + " it, but no run need come near it.";
  if (half_open)
    verdict.explanation =
        "Compositional bound with half-open windows, as textbooks have them: a job released at the instant "
        "at "
        "which another ends does not delay it. Runs of PAL may exceed it.";
  if (requirement.phase.limits())
    verdict.explanation += " It covers the whole run, also what is not " + requirement.phase.text + ".";
}

Table<DeviceId, bool> never_lost(const View& view) {
  Table<DeviceId, bool> kept(view.problem.devices.size());
  for (const DeviceId d : kept.ids()) {
    const Device& device = view.problem.devices[d];
    if (!std::holds_alternative<pan::EventDevice>(device.behaviour) || !device.event.valid()) continue;
    Requirement none;
    none.measure = Measure::loss;
    none.device = d;
    kept[d] = event_loss_bound(view, none).known();
  }
  return kept;
}

/// Every step whose time some requirement asks for, but for those that are timed anyway.
Table<StepId, bool> asked_for(const Problem& problem) {
  Table<StepId, bool> asked(problem.steps.size());
  for (const Requirement& requirement : problem.requirements) {
    // Mostly few of very many steps.
    const auto begin = requirement.at.begin(), end = requirement.at.end();
    for (auto at = std::find(begin, end, true); at != end; at = std::find(at + 1, end, true)) {
      const StepId s(static_cast<std::size_t>(at - begin));
      asked[s] = asked[s] || !is_always_timed(problem.steps[s]);
    }
  }
  return asked;
}

}  // namespace

Analysis analyze(const Problem& skill, const Options& options, bool half_open, const SetAside& set_aside) {
  const double begun = options.clock ? options.clock() : 0;
  const Problem problem = clone_shared_blocks(skill);
  Analysis analysis;
  for (const Requirement& requirement : problem.requirements) {
    analysis.verdicts.push_back(open_verdict(requirement));
    analysis.verdicts.back().method = Method::compositional;
  }
  const Forest forest = forest_of(problem, options.stop, set_aside);
  Why refusal = forest.refusal;
  if (refusal.empty()) {
    const ThreadBehaviours behaviours = thread_behaviours_of(problem, forest, options.stop);
    const Times times = times_of(problem, forest, behaviours, asked_for(problem), options.stop,
                                 half_open ? WindowEnds::half_open : WindowEnds::closed);
    if (times.interrupted) {
      refusal = why(Withheld::interrupted);
    } else {
      const Endurance endurance = endurance_of(problem, forest, behaviours, times);
      const Endurance::Threads& always = endurance.always;
      const View view{problem, forest, behaviours, times, always.reliable, always.lively, always.begun};
      analysis.never_lost = never_lost(view);
      for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
        const Requirement& requirement = problem.requirements[r];
        const Bound bound = bound_of(view, requirement);
        const Bound known = bound.known() ? bound : until_left(view, endurance, requirement, bound_of);
        judge(known, requirement, half_open, analysis.verdicts[r]);
        if (options.addends && analysis.verdicts[r].bound && requirement.measure != Measure::loss)
          analysis.verdicts[r].addends = breakdown_of(view, known.sum);
      }
    }
    analysis.statistics.states = forest.nodes.size();
  }
  if (!refusal.empty()) {
    const Sum whole(1'000'000'000, {Term::Kind::said, {}, {}, {}, refusal.text});
    for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
      const bool load = problem.requirements[r].measure == Measure::load;
      judge({load ? whole : Sum::unbounded(), refusal}, problem.requirements[r], half_open,
            analysis.verdicts[r]);
    }
  }
  if (options.clock) analysis.statistics.seconds = options.clock() - begun;
  return analysis;
}

}  // namespace pal::analyzer::compositional
