#include "pal/driver/proof_chart.hpp"

#include <algorithm>
#include <filesystem>

#include "analyzer/chart/chart.hpp"
#include "analyzer/chart/options.hpp"
#include "analyzer/chart/timeline.hpp"
#include "analyzer/verdict/explain.hpp"
#include "pal/driver/chart_caption.hpp"

namespace pal::driver {
namespace {

using Measure = analyzer::Requirement::Measure;
using State = analyzer::VerdictState;

/// Of a run that fails by an event without a response: from that event to the end. Nothing of one that is
/// lost as it comes.
std::optional<chart::Highlight> unanswered(const Proof& proof, std::size_t index) {
  const analyzer::Requirement& requirement = proof.problem.requirements[index];
  const trace::Trace& run = proof.analysis.verdicts[index].witness->trace;
  if (requirement.events.empty()) return std::nullopt;
  const int channel = requirement.events.front();
  const std::string& message = proof.problem.channels[static_cast<std::size_t>(channel)].message;
  const std::vector<trace::Occurrence> answered =
      trace::responses(run, analyzer::sender_name(proof.problem, channel), message,
                       statements_of(proof, index))
          .answered;
  for (const trace::Event& event : run.events) {
    if (event.kind != trace::Kind::put || !requirement.is_event(event.subject)) continue;
    const bool has = std::any_of(answered.begin(), answered.end(), [&event](const auto& occurrence) {
      return occurrence.from_ns == event.time_ns;
    });
    const std::int64_t end = run.events.back().time_ns;
    if (!has && event.time_ns < end)
      return chart::Highlight{event.time_ns, end, message + " without a response", true, requirement.limit};
  }
  return std::nullopt;
}

chart::Highlight highlight(const Proof& proof, std::size_t index, std::int64_t from, std::int64_t to) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  const std::int64_t limit = verdict.limit.count();
  const bool over = verdict.at_least ? to - from < limit : to - from > limit;
  return {from, to, short_measure_text(proof.problem, index), over, limit};
}

/// "touch.pal:57": the folder would only take room.
std::string arrival_text(const analyzer::Reason& reason) {
  if (reason.line == 0) return {};
  return std::filesystem::path(reason.file).filename().string() + ":" + std::to_string(reason.line);
}

chart::ChartOptions options_for(const Proof& proof, std::size_t index) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  chart::ChartOptions options;
  options.caption = proof_caption(proof, index);
  if (verdict.witness->failed) {
    options.highlight = unanswered(proof, index);
  } else if (verdict.witness->measured.value > 0 && verdict.measure != Measure::loss) {
    options.highlight = highlight(proof, index, verdict.witness->measured.born, verdict.witness->measured.at);
  }
  for (const analyzer::Reason& reason : analyzer::abridged(verdict.reasons)) {
    options.explanation.push_back({reason.from, reason.to, reason.what, reason.actor, arrival_text(reason)});
  }
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
  for (std::size_t step = 0; step < requirement.at.size(); ++step) {
    if (!requirement.at[step] || proof.problem.steps[step].statement < 0) continue;
    const auto& statement =
        proof.problem.statements[static_cast<std::size_t>(proof.problem.steps[step].statement)];
    result.push_back({statement.module, statement.text, statement.line});
  }
  return result;
}

bool shows_in_runs(const analyzer::Requirement& requirement) {
  return requirement.measure == Measure::response ||
         (requirement.measure == Measure::age && requirement.samples.empty());
}

std::optional<trace::Occurrence> longest_in(const trace::Trace& run, const Proof& proof, std::size_t index) {
  const analyzer::Requirement& requirement = proof.problem.requirements[index];
  const auto at = statements_of(proof, index);
  std::vector<trace::Occurrence> all;
  if (requirement.measure == Measure::age && requirement.samples.empty()) {
    all = trace::ages(run, proof.problem.conditions[static_cast<std::size_t>(requirement.condition)], at);
  } else if (requirement.measure == Measure::response) {
    const int channel = requirement.events.front();
    all = trace::responses(run, analyzer::sender_name(proof.problem, channel),
                           proof.problem.channels[static_cast<std::size_t>(channel)].message, at)
              .answered;
  }
  const trace::Occurrence* found = trace::longest(all);
  return found == nullptr ? std::nullopt : std::optional(*found);
}

std::string witness_chart(const Proof& proof, std::size_t index) {
  return chart::svg(chart::timeline(proof.analysis.verdicts[index].witness->trace),
                    options_for(proof, index));
}

std::string overlay_chart(const Proof& proof, std::size_t index, const trace::Trace& measured) {
  chart::OverlayOptions options;
  options.proved = options_for(proof, index);
  if (const auto found = longest_in(measured, proof, index); found && found->length_ns() > 0) {
    options.measured.highlight = highlight(proof, index, found->from_ns, found->to_ns);
  }
  return chart::overlay_svg(chart::timeline(proof.analysis.verdicts[index].witness->trace),
                            chart::timeline(measured), options);
}

}  // namespace pal::driver
