#include "programs/pal/reports/proof_chart.hpp"

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/options.hpp"
#include "analyzer/chart/timeline.hpp"
#include "analyzer/runs/simulate.hpp"
#include "analyzer/verdict/sentence.hpp"
#include "programs/pal/reports/chart_caption.hpp"
#include "programs/pal/reports/loss_run.hpp"

namespace pal::program {
namespace {

using Measure = analyzer::Requirement::Measure;
using State = analyzer::VerdictState;

/// Of a run that fails by an event without a response: from that event to the end. Nothing of one that is
/// lost as it comes.
std::optional<analyzer::chart::Highlight> unanswered(const Proof& proof, std::size_t index) {
  const analyzer::Requirement& requirement = proof.problem.requirements[index];
  const trace::Trace& run = proof.analysis.verdicts[index].witness->trace;
  if (requirement.events.empty()) return std::nullopt;
  const analyzer::ChannelId channel = requirement.events.front();
  const std::string& message = proof.problem.channels[channel].message;
  const std::vector<trace::Occurrence> answered =
      trace::responses(run, analyzer::sender_name(proof.problem, channel), message,
                       statements_of(proof, index))
          .answered;
  for (const trace::Event& event : run.events) {
    if (event.kind != trace::Kind::put || !requirement.is_event(analyzer::ChannelId::of(event.subject)))
      continue;
    const bool has = std::any_of(answered.begin(), answered.end(), [&event](const auto& occurrence) {
      return occurrence.from_ns == event.time_ns;
    });
    const std::int64_t end = run.events.back().time_ns;
    if (!has && event.time_ns < end)
      return analyzer::chart::Highlight{event.time_ns, end, message + " without a response", true,
                                        requirement.limit};
  }
  return std::nullopt;
}

analyzer::chart::Highlight highlight(const Proof& proof, std::size_t index, std::int64_t from,
                                     std::int64_t to) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  const bool over = verdict.allowed().broken_by(to - from);
  return {from, to, short_measure_text(proof.problem, index), over, verdict.limit.count()};
}

/// "touch.pal:57": the folder would only take room.
std::string arrival_text(const analyzer::Reason& reason) {
  if (reason.line == 0) return {};
  return std::filesystem::path(reason.file).filename().string() + ":" + std::to_string(reason.line);
}

std::int64_t length(const analyzer::Reason& reason) {
  return reason.to - reason.from;
}

/// Which of these parts are told: of many the longest.
std::vector<bool> told(const std::vector<analyzer::Reason>& reasons) {
  constexpr std::size_t most = 5;
  std::vector<bool> result(reasons.size(), reasons.size() <= most + 1);
  std::vector<std::size_t> order(reasons.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&reasons](std::size_t a, std::size_t b) {
    return length(reasons[a]) > length(reasons[b]);
  });
  for (std::size_t i = 0; i < std::min(most, order.size()); ++i) result[order[i]] = true;
  return result;
}

/// These parts in their order, the longest of them with what is inside it, and so on.
void unfold(const std::vector<analyzer::Reason>& reasons, int depth,
            std::vector<analyzer::chart::Segment>& out) {
  const std::vector<bool> tells = depth == 0 ? std::vector<bool>(reasons.size(), true) : told(reasons);
  const auto longest = std::max_element(reasons.begin(), reasons.end(),
                                        [](const auto& a, const auto& b) { return length(a) < length(b); });
  analyzer::chart::Segment rest;
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    if (!tells[i]) {
      rest.to_ns += length(reasons[i]);
      ++left_out;
      continue;
    }
    out.push_back(segment_of(reasons[i], depth));
    if (&reasons[i] == &*longest) unfold(reasons[i].inside, depth + 1, out);
  }
  if (left_out == 0) return;
  rest.text = std::to_string(left_out) + " shorter parts";
  rest.depth = depth;
  out.push_back(rest);
}

/// The run of a verdict that has one, as it is drawn. Of a value that grows in a loop the first turns say
/// all.
const analyzer::Witness& drawn(const analyzer::Verdict& verdict) {
  return verdict.loop_growth ? verdict.loop_growth->first_turns : *verdict.witness;
}

std::vector<analyzer::chart::Segment> explanation_of(const std::vector<analyzer::Reason>& reasons) {
  std::vector<analyzer::chart::Segment> parts;
  unfold(analyzer::abridged(reasons), 0, parts);
  return parts;
}

analyzer::chart::ChartOptions options_for(const Proof& proof, std::size_t index) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  analyzer::chart::ChartOptions options;
  options.caption = proof_caption(proof, index);
  const analyzer::Witness& run = drawn(verdict);
  if (run.failed) {
    options.highlight = unanswered(proof, index);
  } else if (run.measured.value > 0 && verdict.measure != Measure::loss) {
    options.highlight = highlight(proof, index, run.measured.born, run.measured.at);
    options.highlight->missed = verdict.measure == Measure::reaction;
  }
  options.explanation = explanation_of(verdict.reasons);
  return options;
}

}  // namespace

bool has_worst_run(const analyzer::Verdict& verdict) {
  if (!verdict.witness || verdict.measure == Measure::load) return false;
  return verdict.measure != Measure::loss || verdict.witness->failed || verdict.witness->measured.value > 0;
}

std::optional<std::size_t> most_interesting(const Proof& proof) {
  std::optional<std::size_t> best;
  double best_share = 0;
  for (std::size_t i = 0; i < proof.analysis.verdicts.size(); ++i) {
    const analyzer::Verdict& verdict = proof.analysis.verdicts[i];
    if (!has_worst_run(verdict)) continue;
    if (verdict.state == State::fails) return i;
    if (verdict.limit.count() == 0 || verdict.at_least) continue;
    const double share =
        static_cast<double>(verdict.witness->measured.value) / static_cast<double>(verdict.limit.count());
    if (!best || share > best_share) {
      best = i;
      best_share = share;
    }
  }
  return best;
}

std::vector<trace::StatementName> statements_of(const Proof& proof, std::size_t index) {
  const analyzer::Requirement& requirement = proof.problem.requirements[index];
  std::vector<trace::StatementName> result;
  for (const analyzer::StepId step : requirement.at.ids()) {
    if (!requirement.at[step] || !proof.problem.steps[step].statement.valid()) continue;
    const auto& statement = proof.problem.statements[proof.problem.steps[step].statement];
    result.push_back({statement.module, statement.text, statement.line});
  }
  return result;
}

bool shows_in_runs(const analyzer::Requirement& requirement) {
  return !requirement.phase.limits() &&
         (requirement.measure == Measure::response ||
          (requirement.measure == Measure::age && requirement.samples.empty()));
}

std::optional<trace::Occurrence> longest_in(const trace::Trace& run, const Proof& proof, std::size_t index) {
  return longest_in(run, trace::events_of(run), proof, index);
}

std::optional<trace::Occurrence> longest_in(const trace::Trace& tables, const trace::EventSource& events,
                                            const Proof& proof, std::size_t index) {
  const analyzer::Requirement& requirement = proof.problem.requirements[index];
  if (!shows_in_runs(requirement)) return std::nullopt;
  const auto at = statements_of(proof, index);
  if (requirement.measure == Measure::age)
    return trace::longest_age(tables, events, proof.problem.conditions[requirement.condition], at);
  const analyzer::ChannelId channel = requirement.events.front();
  return trace::longest_response(tables, events, analyzer::sender_name(proof.problem, channel),
                                 proof.problem.channels[channel].message, at);
}

namespace {

std::optional<analyzer::chart::Highlight> longest_interval(const Proof& proof, std::size_t index,
                                                           const trace::Trace& run) {
  const auto found = longest_in(run, proof, index);
  if (!found || found->length_ns() == 0) return std::nullopt;
  return highlight(proof, index, found->from_ns, found->to_ns);
}

ShownRun shown_loss(const Proof& proof, std::size_t index, LossRun found) {
  const bool lost = !found.losses.empty();
  ShownRun shown{
      lost ? "worst run" : "a run without a loss", std::move(found.run), {}, std::move(found.reasons)};
  shown.options.caption = proof_caption(proof, index);
  shown.options.highlight = found.highlight;
  shown.options.window = found.window;
  shown.options.losses = std::move(found.losses);
  shown.options.explanation = explanation_of(shown.reasons);
  return shown;
}

/// One with the worst times that shows a value: what is proved without a run, or undecided, is seen in it.
std::optional<ShownRun> usual_run(const Proof& proof, std::size_t index) {
  constexpr std::size_t most_events = 20'000;
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  if (!shows_in_runs(proof.problem.requirements[index]) || !analyzer::fits_exploration(proof.problem) ||
      proof.analysis.zeno_run || proof.ended || verdict.state == State::never) {
    return std::nullopt;
  }
  analyzer::SimulationOptions how;
  how.max_events = most_events;
  const analyzer::Watch nothing;
  const analyzer::Machine machine(proof.problem, nothing);
  ShownRun shown{"a run with the worst times", analyzer::simulate(machine, how).trace, {}, {}};
  shown.run.origin = "simulated";
  shown.options.highlight = longest_interval(proof, index, shown.run);
  if (!shown.options.highlight) return std::nullopt;
  shown.options.caption = proof_caption(proof, index);
  const std::int64_t seen = shown.options.highlight->to_ns - shown.options.highlight->from_ns;
  shown.options.caption.figures += "; " + analyzer::chart::duration_text(seen) + " in this run";
  return shown;
}

}  // namespace

analyzer::chart::Segment segment_of(const analyzer::Reason& reason, int depth) {
  return {reason.from, reason.to, reason.what, reason.actor, arrival_text(reason), depth};
}

std::optional<ShownRun> shown_run(const Proof& proof, std::size_t index) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  if (verdict.measure == Measure::loss) {
    if (auto found = loss_run(proof, index)) return shown_loss(proof, index, std::move(*found));
  }
  if (!has_worst_run(verdict)) return usual_run(proof, index);
  return ShownRun{verdict.loop_growth ? "first turns" : "worst run", drawn(verdict).trace,
                  options_for(proof, index), verdict.reasons};
}

ShownRun measured_run(const Proof& proof, std::size_t index, const trace::Trace& measured) {
  ShownRun shown{"measured run", measured, {}, {}};
  shown.options.caption = proof_caption(proof, index);
  shown.options.highlight = longest_interval(proof, index, measured);
  return shown;
}

std::string overlay_chart(const Proof& proof, std::size_t index, const trace::Trace& measured, bool narrow) {
  analyzer::chart::OverlayOptions options;
  options.proved = options_for(proof, index);
  options.proved.narrow = narrow;
  options.measured.highlight = longest_interval(proof, index, measured);
  return analyzer::chart::overlay_svg(analyzer::chart::timeline(drawn(proof.analysis.verdicts[index]).trace),
                                      analyzer::chart::timeline(measured), options);
}

}  // namespace pal::program
