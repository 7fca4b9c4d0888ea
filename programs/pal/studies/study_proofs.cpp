#include "programs/pal/studies/study_proofs.hpp"

#include <algorithm>

#include "analyzer/whatif/figures.hpp"
#include "pal/check/network/environment.hpp"
#include "pal/pan/times.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "pal/support/nearest.hpp"
#include "programs/pal/session/kept_here.hpp"
#include "study/cells.hpp"

namespace pal::program {
namespace {

std::string list_of(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& each : names) list += (list.empty() ? "'" : ", '") + each + "'";
  return list;
}

/// The first error, in a line.
std::string first_error(const Diagnostics& diagnostics) {
  for (const Diagnostic& finding : diagnostics.all())
    if (finding.severity == Severity::error)
      return std::string(pal::name(finding.code)) + ": " + finding.message;
  return "the model of the skill in this environment cannot be built";
}

}  // namespace

StudyProofs::StudyProofs(const study::Study& study, const Session& session, const ProofLimits& limits)
    : study_(study), session_(session), limits_(limits) {
  for (const pan::Network& skill : session.specification.skills) {
    const std::string hash = study::sha256(study::canonical_text(skill));
    for (const pan::Environment& environment : session.specification.environments) {
      if (!is_of(skill, environment, session.specification)) continue;
      Made made{&skill, &environment, hash, {}};
      Diagnostics ignored;
      if (const auto problem = problem_of(skill, environment, session.sources, ignored)) {
        for (const analyzer::Verdict& verdict : analyzer::nothing_known(*problem, "").verdicts)
          made.requirements.emplace_back(verdict.requirement, study::row_of(verdict));
      } else {
        for (const auto& requirement : skill.requirements)
          made.requirements.emplace_back(requirement.name, study::Row{});
      }
      for (const auto& [name, row] : made.requirements) index_of(name, all_requirements_);
      if (std::any_of(made.requirements.begin(), made.requirements.end(),
                      [this](const auto& each) { return asked_for(each.first); }))
        pairs_.push_back(std::move(made));
    }
  }
}

bool StudyProofs::asked_for(const std::string& requirement) const {
  return study_.requirements.empty() || std::find(study_.requirements.begin(), study_.requirements.end(),
                                                  requirement) != study_.requirements.end();
}

std::uint32_t StudyProofs::index_of(const std::string& text, std::vector<std::string>& texts) const {
  const auto index = static_cast<std::size_t>(std::find(texts.begin(), texts.end(), text) - texts.begin());
  if (index == texts.size()) texts.push_back(text);
  return static_cast<std::uint32_t>(index);
}

std::optional<std::string> StudyProofs::parameter_called(const std::string& name) const {
  const auto dot = name.rfind('.');
  const std::string last = dot == std::string::npos ? name : name.substr(dot + 1);
  for (const pan::Network& skill : session_.specification.skills)
    for (const pan::Parameter& parameter : skill.skill.parameters)
      if (parameter.name == last) return skill.skill.name;
  return std::nullopt;
}

std::optional<study::Refusal> StudyProofs::trouble_of(const study::Figure& figure) const {
  for (const pan::Environment& environment : session_.specification.environments) {
    for (const study::Choice& choice : figure.choices) {
      // A figure may be one that only some of the skills have.
      pan::Environment changed = environment;
      for (const pan::Network& skill : session_.specification.skills)
        changed = pan::with_times_of(skill, std::move(changed));
      for (const std::string& change : choice.changes) {
        const std::string wrong = analyzer::whatif::change(changed, change);
        if (wrong.empty()) continue;
        if (const auto skill = parameter_called(figure.name))
          return study::Refusal{figure.line,
                                "figure '" + figure.name + "' is a parameter of skill " + *skill +
                                    ", and no proof depends on it",
                                "leave it out: what is proved holds for all values of its range"};
        return study::Refusal{figure.line, "figure '" + figure.name + "': " + wrong,
                              "pal whatif --set takes the same names (docs/reference/what-if.md)"};
      }
    }
  }
  return std::nullopt;
}

std::optional<study::Refusal> StudyProofs::trouble() const {
  if (session_.specification.skills.empty())
    return study::Refusal{0, "there is no SKILL in the files", "name one"};
  if (session_.specification.environments.empty())
    return study::Refusal{0, "there is no ENVIRONMENT in the files",
                          "name one: environments = [\"cell.pal\"]"};
  for (const pan::Network& skill : session_.specification.skills)
    if (skill.requirements.empty())
      return study::Refusal{
          0, "skill " + skill.skill.name + " has no REQUIREMENT, so nothing of it would be checked",
          "write one, or name the skills that have: skills = [\"…\"]"};
  for (const std::string& each : study_.requirements) {
    if (std::find(all_requirements_.begin(), all_requirements_.end(), each) != all_requirements_.end())
      continue;
    const auto close = nearest(each, all_requirements_);
    return study::Refusal{0,
                          "no skill has a requirement '" + each + "'; there is " + list_of(all_requirements_),
                          close ? "did you mean '" + *close + "'?" : ""};
  }
  if (pairs_.empty()) return study::Refusal{0, "no skill is proved in any of the environments", ""};
  for (const study::Figure& figure : study_.figures)
    if (auto trouble = trouble_of(figure)) return trouble;
  return std::nullopt;
}

std::vector<study::Pair> StudyProofs::pair_names() const {
  std::vector<study::Pair> names;
  for (const Made& pair : pairs_) names.push_back({pair.skill->skill.name, pair.environment->name});
  return names;
}

pan::Environment StudyProofs::environment_at(std::uint64_t proof) const {
  const Made& pair = pairs_[proof % pairs_.size()];
  pan::Environment environment = pan::with_times_of(*pair.skill, *pair.environment);
  for (const std::string& change :
       study::changes_of(study_, study::choices_at(study_, proof / pairs_.size())))
    analyzer::whatif::change(environment, change);
  return environment;
}

std::string StudyProofs::key(std::uint64_t proof) {
  const std::uint64_t point = proof / pairs_.size();
  if (point != hashed_point_) environment_hashes_.assign(pairs_.size(), "");
  hashed_point_ = point;
  const std::size_t pair = proof % pairs_.size();
  std::string& hash = environment_hashes_[pair];
  if (hash.empty()) hash = study::sha256(study::canonical_text(environment_at(proof)));
  return study::proof_key(pairs_[pair].skill_hash, hash, key_options(limits_));
}

std::string StudyProofs::limit_key(std::uint64_t proof) {
  return study::sha256(key(proof) + "\nwithin " + std::to_string(limits_.seconds) + " s");
}

std::optional<study::KeptProof> StudyProofs::prove(std::uint64_t proof, study::KeptProof& at_limit) {
  const pan::Environment environment = environment_at(proof);
  Diagnostics diagnostics;
  check::check_figures(environment, diagnostics);
  std::optional<analyzer::Problem> problem;
  if (!diagnostics.has_errors())
    problem = problem_of(*pairs_[proof % pairs_.size()].skill, environment, session_.sources, diagnostics);
  if (!problem || diagnostics.has_errors()) return study::KeptProof{first_error(diagnostics), {}, {}};
  ProofLimits limits = limits_;
  limits.begun = std::chrono::steady_clock::now();  // each proof has its time
  analyzer::Options options = options_of(limits);
  const auto limited = note_stop(options);
  study::KeptProof made = kept_form(analyzer::analyze(*problem, limits.analysis, options));
  if (!*limited && !options.stop()) return made;
  at_limit = std::move(made);
  return std::nullopt;
}

std::optional<Proof> StudyProofs::prove_thoroughly(std::uint64_t proof) {
  const pan::Environment environment = environment_at(proof);
  Diagnostics diagnostics;
  check::check_figures(environment, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  auto problem = problem_of(*pairs_[proof % pairs_.size()].skill, environment, session_.sources, diagnostics);
  if (!problem || diagnostics.has_errors()) return std::nullopt;
  ProofLimits limits = limits_;
  limits.begun = std::chrono::steady_clock::now();
  analyzer::Analysis analysis =
      analyzer::analyze(*problem, analyzer::AnalysisChoice::thorough, options_of(limits));
  return Proof{std::move(*problem), std::move(analysis)};
}

void StudyProofs::add_rows(std::uint64_t proof, const study::KeptProof& kept, const std::string& note,
                           study::Table& table) {
  const auto pair = static_cast<std::uint32_t>(proof % pairs_.size());
  const auto place = [&](study::Row row, const std::string& requirement, const std::string& why) {
    row.point = static_cast<std::uint32_t>(proof / pairs_.size());
    row.pair = pair;
    row.requirement = index_of(requirement, table.requirements);
    row.note = index_of(why, table.notes);
    table.rows.push_back(row);
  };
  if (kept.verdicts.empty()) {
    const std::string& why = kept.refused.empty() ? note : kept.refused;
    for (const auto& [name, described] : pairs_[pair].requirements) {
      study::Row row = described;
      row.outcome = study::Outcome::not_checked;
      if (asked_for(name)) place(row, name, why);
    }
    return;
  }
  for (const analyzer::Verdict& verdict : kept.verdicts)
    if (asked_for(verdict.requirement)) place(study::row_of(verdict), verdict.requirement, note);
}

}  // namespace pal::program
