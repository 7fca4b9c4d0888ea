#include "programs/pal/reports/editor_proofs.hpp"

#include <algorithm>
#include <charconv>
#include <memory>
#include <string_view>
#include <utility>

#include "analyzer/analysis.hpp"
#include "analyzer/chart/chart.hpp"
#include "pal/check/resources.hpp"
#include "pal/check/shared_uses.hpp"
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
  made.limit = whole_text(verdict.allowed().figure);
  made.measure = measure_text(proof.problem, index);
  made.explanation = verdict.explanation.text();
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

/// The verdicts on a problem: those that were kept, and those that are found now.
class Known {
 public:
  template <class Find>
  Known(analyzer::Problem problem, bool whole, const Find& find)
      : proof{std::move(problem), {}, true, false, false} {
    const auto kept = find(proof.problem);
    proof.analysis = analyzer::nothing_known(proof.problem, "");
    for (std::size_t r = 0; r < kept.size(); ++r) {
      if (kept[r]) proof.analysis.verdicts[r] = kept[r]->verdict;
      if (!kept[r] || (whole && !kept[r]->whole)) open_.push_back(r);
    }
  }

  const std::vector<std::size_t>& open() const { return open_; }

  /// With the requirements alone that are to be proved.
  analyzer::Problem open_problem() const {
    analyzer::Problem part = proof.problem;
    part.requirements.clear();
    for (const std::size_t r : open_) part.requirements.push_back(proof.problem.requirements[r]);
    return part;
  }

  void take(analyzer::Analysis analysis) {
    for (std::size_t i = 0; i < open_.size(); ++i)
      proof.analysis.verdicts[open_[i]] = std::move(analysis.verdicts[i]);
    analysis.verdicts = std::move(proof.analysis.verdicts);
    proof.analysis = std::move(analysis);
  }

  /// Of what is open: what is decided while the analysis of it has come so far, by requirement of the
  /// problem; all else is undecided. What holds by a bound is decided only once it is known that time passes
  /// and that something is measured.
  std::vector<analyzer::Verdict> decided(const analyzer::Analysis& now) const {
    auto verdicts = analyzer::nothing_known(proof.problem, "").verdicts;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const auto& verdict = now.verdicts[i];
      if (verdict.state == analyzer::VerdictState::fails || !now.bounds_only) verdicts[open_[i]] = verdict;
    }
    return verdicts;
  }

  /// What can be said meanwhile; `decided_now` are decided().
  language_server::SkillProof under_way(language_server::SkillProof made, const analyzer::Analysis& now,
                                        const std::vector<analyzer::Verdict>& decided_now) const {
    Proof told{proof.problem, proof.analysis, true, false, false};
    std::vector<bool> decided(told.problem.requirements.size(), true);
    for (std::size_t i = 0; i < open_.size(); ++i) {
      told.analysis.verdicts[open_[i]] = now.verdicts[i];
      decided[open_[i]] = decided_now[open_[i]].state != analyzer::VerdictState::undecided;
    }
    for (std::size_t r = 0; r < decided.size(); ++r) {
      auto each = requirement_of(told, r);
      if (!decided[r]) {
        each.state = "open";
        each.findings.clear();
        each.cause = {};
        each.shares.clear();
        if (!told.analysis.verdicts[r].bound) each.bound.clear();
      }
      each.has_run = false;
      made.requirements.push_back(std::move(each));
    }
    return made;
  }

  Proof proof;

 private:
  std::vector<std::size_t> open_;
};

}  // namespace

language_server::SkillProof EditorProver::prove(
    const pan::Network& skill, const pan::Environment& environment, const SourceManager& sources,
    language_server::Depth depth, double seconds, const std::function<bool()>& stop,
    const std::function<void(language_server::SkillProof)>& told) const {
  language_server::SkillProof made{skill.skill.name, environment.name, {}, {}, false, {}};
  Diagnostics diagnostics;
  check::check_listed(skill, environment, diagnostics);
  check::check_shared_uses(skill, environment, diagnostics);
  auto problem = analyzer::make_problem(skill, environment, diagnostics, &sources);
  made.findings = diagnostics.all();
  made.chart = [](std::size_t, bool) { return std::nullopt; };
  if (!problem || diagnostics.has_errors()) return made;
  const bool whole = depth == language_server::Depth::whole;
  const ProofKey key = key_of(skill, environment, *problem, sources);
  Known known(std::move(*problem), whole, [&](const analyzer::Problem& of) { return kept_.find(key, of); });
  bool ended = false;
  if (!known.open().empty()) {
    ProofLimits limits;
    limits.seconds = seconds;
    analyzer::Options options = options_of(limits);
    options.verdicts_only = !whole;
    options.stop = [usual = options.stop, stop] { return usual() || stop(); };
    if (told) {
      options.known = [&](const analyzer::Analysis& now) {
        const auto decided = known.decided(now);
        // A text with the same words may come before the analysis has ended.
        kept_.keep(key, known.proof.problem, decided, KeptProofs::Found::at_first);
        if (!stop()) told(known.under_way(made, now, decided));
      };
    }
    const auto choice = whole ? analyzer::AnalysisChoice::thorough : analyzer::AnalysisChoice::automatic;
    known.take(analyzer::analyze(known.open_problem(), choice, options));
    ended = options.stop();
    // Where time stands still the run that shows it is told, which is not kept.
    if (!stop() && !known.proof.analysis.zeno_run)
      kept_.keep(key, known.proof.problem, known.proof.analysis.verdicts,
                 whole && !ended ? KeptProofs::Found::whole : KeptProofs::Found::at_the_end);
  }
  const auto proof = std::make_shared<const Proof>(
      Proof{std::move(known.proof.problem), std::move(known.proof.analysis), true, ended, false});
  made.ended = proof->ended;
  for (std::size_t i = 0; i < proof->analysis.verdicts.size(); ++i)
    made.requirements.push_back(requirement_of(*proof, i));
  made.chart = [proof](std::size_t index, bool narrow) -> std::optional<language_server::Drawing> {
    auto shown = shown_run(*proof, index);
    if (!shown) return std::nullopt;
    shown->options.ids = true;
    shown->options.narrow = narrow;
    const auto timeline = analyzer::chart::timeline(shown->run);
    language_server::Drawing drawing{analyzer::chart::svg(timeline, shown->options), {}};
    drawing.places = places_of(drawing.svg, timeline, proof->problem);
    return drawing;
  };
  return made;
}

}  // namespace pal::program
