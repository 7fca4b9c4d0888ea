#include "programs/pal/reports/editor_proofs.hpp"

#include <algorithm>
#include <charconv>
#include <memory>
#include <string_view>
#include <utility>

#include "analyzer/analysis.hpp"
#include "analyzer/chart/chart.hpp"
#include "pal/check/resources.hpp"
#include "pal/check/shared_messages.hpp"
#include "pal/support/duration_text.hpp"
#include "programs/pal/reports/proof_chart.hpp"
#include "programs/pal/session/measure_text.hpp"
#include "programs/pal/session/proof.hpp"

namespace pal::program {
namespace {

SourceSpan place_of(const Proof& proof, const analyzer::Reason& reason) {
  for (const auto& statement : proof.problem.statements) {
    if (reason.line != 0 && statement.line == reason.line && statement.file == reason.file)
      return statement.where;
  }
  return {};
}

std::string what_of(const analyzer::Reason& reason) {
  return (reason.actor.empty() ? "" : reason.actor + " ") + reason.what;
}

/// Parts that have parts of their own by the same actor give way to these: not that a value ages, but the
/// wait that it ages in.
void add_leaves(const std::vector<analyzer::Reason>& reasons, std::vector<analyzer::Reason>& leaves) {
  for (const auto& reason : reasons) {
    const bool own = !reason.inside.empty() &&
                     std::all_of(reason.inside.begin(), reason.inside.end(), [&](const auto& each) {
                       return each.actor == reason.actor && each.line != 0;
                     });
    if (own) {
      add_leaves(reason.inside, leaves);
    } else {
      leaves.push_back(reason);
    }
  }
}

/// The shares of the worst run; of those the greatest is the cause.
void add_shares(const Proof& proof, std::size_t index, language_server::ProvedRequirement& made) {
  std::vector<analyzer::Reason> leaves;
  add_leaves(proof.analysis.verdicts[index].reasons, leaves);
  std::int64_t longest = 0;
  for (const auto& reason : leaves) {
    const auto where = place_of(proof, reason);
    const auto time = reason.to - reason.from;
    if (!where.valid() || time <= 0) continue;
    made.shares.push_back({where, to_text(Duration(time)), what_of(reason)});
    if (time <= longest) continue;
    longest = time;
    made.cause = where;
    made.cause_text = to_text(Duration(time)) + " of " + made.bound + ": " + what_of(reason);
  }
}

language_server::ProvedRequirement requirement_of(const Proof& proof, std::size_t index) {
  const analyzer::Verdict& verdict = proof.analysis.verdicts[index];
  language_server::ProvedRequirement made;
  made.name = verdict.requirement;
  made.state = analyzer::name(verdict.state);
  made.bound = bound_text(verdict);
  made.limit = whole_text(verdict.measure, verdict.limit);
  made.measure = measure_text(proof.problem, index);
  made.explanation = verdict.explanation;
  made.exact = verdict.exact;
  made.has_run = has_worst_run(verdict);
  add_shares(proof, index, made);
  Diagnostics found;
  report_unmet(proof, index, false, found);
  made.findings = found.all();
  return made;
}

/// Where the elements of a chart stand: each id="bar-LANE-NUMBER…" of it.
std::vector<language_server::Drawing::Place> places_of(const std::string& svg,
                                                       const analyzer::chart::Timeline& timeline,
                                                       const analyzer::Problem& problem) {
  std::vector<language_server::Drawing::Place> places;
  constexpr std::string_view mark = " id=\"bar-";
  for (auto at = svg.find(mark); at != std::string::npos; at = svg.find(mark, at + 1)) {
    const auto begin = at + 5;
    const auto end = svg.find('"', begin);
    if (end == std::string::npos) break;
    std::size_t lane = 0, number = 0;
    const char* last = svg.data() + end;
    const auto first = std::from_chars(svg.data() + at + mark.size(), last, lane);
    if (first.ec != std::errc{} || first.ptr == last ||
        std::from_chars(first.ptr + 1, last, number).ec != std::errc{})
      continue;
    const auto& bar = timeline.lanes.at(lane).bars.at(number);
    const auto found =
        std::find_if(problem.statements.begin(), problem.statements.end(), [&](const auto& each) {
          return bar.line != 0 && each.line == bar.line && each.file == bar.file && each.text == bar.text;
        });
    if (found != problem.statements.end()) places.push_back({svg.substr(begin, end - begin), found->where});
  }
  return places;
}

}  // namespace

language_server::SkillProof EditorProver::prove(const pan::Network& skill,
                                                const pan::Environment& environment,
                                                const SourceManager& sources, language_server::Depth depth,
                                                double seconds, const std::function<bool()>& stop) const {
  language_server::SkillProof made{skill.skill.name, environment.name, {}, {}, false, {}};
  Diagnostics diagnostics;
  check::check_listed(skill, environment, diagnostics);
  check::check_shared_messages(skill, environment, diagnostics);
  auto problem = analyzer::make_problem(skill, environment, diagnostics, &sources);
  made.findings = diagnostics.all();
  made.chart = [](std::size_t) { return std::nullopt; };
  if (!problem || diagnostics.has_errors()) return made;
  ProofLimits limits;
  limits.seconds = seconds;
  analyzer::Options options = options_of(limits);
  options.stop = [usual = options.stop, stop] { return usual() || stop(); };
  const auto choice = depth == language_server::Depth::quick ? analyzer::AnalysisChoice::automatic
                                                             : analyzer::AnalysisChoice::thorough;
  analyzer::Analysis analysis = analyzer::analyze(*problem, choice, options);
  const auto proof = std::make_shared<const Proof>(
      Proof{std::move(*problem), std::move(analysis), true, options.stop(), false});
  made.ended = proof->ended;
  for (std::size_t i = 0; i < proof->analysis.verdicts.size(); ++i)
    made.requirements.push_back(requirement_of(*proof, i));
  made.chart = [proof](std::size_t index) -> std::optional<language_server::Drawing> {
    auto shown = shown_run(*proof, index);
    if (!shown) return std::nullopt;
    shown->options.ids = true;
    const auto timeline = analyzer::chart::timeline(shown->run);
    language_server::Drawing drawing{analyzer::chart::svg(timeline, shown->options), {}};
    drawing.places = places_of(drawing.svg, timeline, proof->problem);
    return drawing;
  };
  return made;
}

}  // namespace pal::program
