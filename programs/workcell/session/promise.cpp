#include "programs/workcell/session/promise.hpp"

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>
#include <variant>

#include "programs/pal/reports/proof_chart.hpp"
#include "programs/pal/session/memory.hpp"
#include "programs/workcell/session/failure.hpp"

namespace pal::workcell {
namespace {

/// Of a long run, what a chart of its longest interval needs: the events of a second before and after it.
trace::Trace around(const trace::Trace& tables, const trace::EventSpool& events,
                    const std::optional<trace::Occurrence>& longest) {
  constexpr std::int64_t margin = 1'000'000'000;
  const std::int64_t from = longest ? longest->from_ns - margin : 0;
  const std::int64_t to = longest ? longest->to_ns + margin : 2 * margin;
  trace::Trace part = tables;
  part.events.clear();
  events.for_each([&](const trace::Event& event) {
    if (event.time_ns >= from && event.time_ns <= to) part.events.push_back(event);
  });
  return part;
}

/// As RealTime::tolerance and cost_tolerance widen what a run is watched with. PAL has no word for late
/// frames.
void widen(pan::Environment& environment, const Tolerances& tolerances) {
  for (pan::DeviceTiming& device : environment.devices) {
    if (auto* events = std::get_if<pan::EventDevice>(&device.behaviour)) {
      events->jitter += tolerances.device;
    } else if (auto* served = std::get_if<pan::RequestDevice>(&device.behaviour)) {
      served->answer.best = std::max(Duration::zero(), served->answer.best - tolerances.device);
      served->answer.worst += tolerances.device;
    }
  }
  pan::Costs& costs = environment.costs;
  for (Interval* cost : {&costs.send, &costs.receive, &costs.set, &costs.read, &costs.test})
    cost->worst += tolerances.cost;
}

}  // namespace

std::vector<Promise> promises(const KnownSkill& skill, const runtime::Outcome& outcome,
                              const trace::EventSpool* events, const Tolerances& tolerances) {
  const trace::Trace& run = outcome.trace;
  std::vector<Promise> result;
  if (skill.pal_file.empty()) return result;
  std::ostringstream out, err;
  program::Session session;
  program::Selection selection;
  selection.files = {skill.pal_file};
  selection.environments = {skill.environment_file};
  selection.skill = skill.name;
  const program::Console console{out, err, *skill.texts};
  const bool chosen = program::read(selection, console, session);
  for (pan::Environment& environment : session.specification.environments) widen(environment, tolerances);
  std::vector<program::Proof> proofs;
  if (chosen && !session.diagnostics.has_errors()) proofs = program::prove(session, {});
  program::give_back_memory();
  if (proofs.empty()) {
    program::show_findings(session, console);
    throw Failure(ExitStatus::wrong_specification, selection.files.front(),
                  "the PAL of the skill is wrong\n" + err.str());
  }
  for (const program::Proof& proof : proofs) {
    for (std::size_t i = 0; i < proof.analysis.verdicts.size(); ++i) {
      const analyzer::Verdict& verdict = proof.analysis.verdicts[i];
      const analyzer::Requirement& requirement = proof.problem.requirements[i];
      Promise promise;
      promise.requirement = verdict.requirement;
      promise.measure = program::measure_text(proof.problem, i);
      promise.proved = verdict.bound;
      promise.at_least = verdict.at_least;
      promise.exact = verdict.exact;
      for (const runtime::MeasuredRequirement& measured : outcome.requirements) {
        if (measured.name != verdict.requirement) continue;
        promise.unit = measured.unit;
        promise.measured = measured.worst;
      }
      if (program::shows_in_runs(requirement) && verdict.witness && verdict.bound) {
        const auto longest = events == nullptr
                                 ? program::longest_in(run, proof, i)
                                 : program::longest_in(run, trace::events_of(*events), proof, i);
        promise.chart =
            program::overlay_chart(proof, i, events == nullptr ? run : around(run, *events, longest));
      }
      result.push_back(std::move(promise));
    }
  }
  return result;
}

}  // namespace pal::workcell
