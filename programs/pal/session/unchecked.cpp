#include "programs/pal/session/unchecked.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "pal/support/finding.hpp"

namespace pal::program {
namespace {

struct Why {
  std::string reason;
  std::string hint;
};

/// The measure as JSON names it, and the limit that belongs to it.
struct MeasureName {
  Duration& limit;

  const char* operator()(const pan::Response&) const { return "response"; }
  const char* operator()(const pan::Age&) const { return "age"; }
  const char* operator()(const pan::Reaction&) const { return "reaction"; }
  const char* operator()(const pan::Completing&) const { return "duration"; }
  const char* operator()(const pan::Load&) const { return "load"; }
  const char* operator()(const pan::BusyPeriod&) const { return "busy"; }
  const char* operator()(const pan::Loss& loss) const {
    limit = Duration(loss.most);
    return "loss";
  }
  const char* operator()(const pan::Passes& passes) const {
    limit = passes.most ? *passes.most : passes.least.value_or(Duration::zero());
    return passes.most ? "interval" : "least_interval";
  }
};

void add_requirements(const pan::Network& skill, const std::string& environment, const Why& why,
                      std::vector<Unchecked>& list) {
  for (const pan::Requirement& requirement : skill.requirements) {
    Unchecked row{skill.skill.name, environment, requirement.name,  "",   requirement.limit,
                  why.reason,       why.hint,    requirement.where, false};
    row.measure = std::visit(MeasureName{row.limit}, requirement.measure);
    list.push_back(std::move(row));
  }
}

Why why(Unproved unproved) {
  switch (unproved) {
    case Unproved::nowhere:
      break;
    case Unproved::wrong:
      return {"the specification has errors", "correct them first"};
    case Unproved::not_asked_for:
      return {"times were not asked for", "check it without --without-times"};
    case Unproved::ended_by_user:
      return {"the check was ended by you", "let it go on, or limit it with --timeout"};
  }
  return {"no environment was given", "give one with --environment FILE, or by USES"};
}

bool is_of(const Proof& proof, const pan::Network& skill, const pan::Environment& environment) {
  return proof.problem.skill == skill.skill.name && proof.problem.environment == environment.name;
}

}  // namespace

std::vector<Unchecked> unchecked(const Session& session, const std::vector<Proof>& proofs,
                                 Unproved unproved) {
  const bool wrong = unproved == Unproved::wrong;
  const Why without_proof = why(unproved);
  const Why without_environment =
      unproved == Unproved::ended_by_user ? why(Unproved::nowhere) : without_proof;
  const auto& environments = session.specification.environments;
  std::vector<Unchecked> list;
  for (const pan::Network& skill : session.specification.skills) {
    const std::string& name = skill.skill.name;
    if (skill.requirements.empty() && !wrong)
      list.push_back({name,
                      {},
                      {},
                      "",
                      {},
                      "the skill has no REQUIREMENT",
                      "write what it must keep, as REQUIREMENT quick : DURATION TO COMPLETION 0 AT MOST 1 s",
                      skill.skill.where,
                      false});
    if (environments.empty()) {
      add_requirements(skill, {}, without_environment, list);
      continue;
    }
    for (const pan::Environment& environment : environments) {
      const bool proved = std::any_of(proofs.begin(), proofs.end(),
                                      [&](const Proof& proof) { return is_of(proof, skill, environment); });
      if (!proved) add_requirements(skill, environment.name, without_proof, list);
    }
  }
  if (session.specification.skills.empty() && !wrong) {
    const SourceSpan begin = session.sources.size() == 0 ? SourceSpan{} : SourceSpan{FileId(0), 0, 0};
    const Why no_skill{"there is no SKILL in the files given",
                       "name the file with the skill, or use it by USES"};
    const Why& none = unproved == Unproved::ended_by_user ? without_proof : no_skill;
    list.push_back({{}, {}, {}, "", {}, none.reason, none.hint, begin, false});
  }
  return list;
}

PartialDiagnostic finding_of(const Unchecked& unchecked) {
  if (unchecked.skill.empty()) return {Finding::nothing_checked, unchecked.reason, unchecked.hint};
  const std::string what = unchecked.requirement.empty()
                               ? "skill '" + unchecked.skill + "'"
                               : "'" + unchecked.requirement + "' of " + unchecked.skill +
                                     (unchecked.environment.empty() ? "" : " in " + unchecked.environment);
  return {Finding::not_checked, what, unchecked.reason, unchecked.hint};
}

void report_unchecked(const std::vector<Unchecked>& list, Session& session) {
  for (const Unchecked& row : list) {
    if (!row.left_out) session.diagnostics.report(finding_of(row), row.where);
  }
}

bool has_verdicts(const std::vector<Proof>& proofs) {
  return std::any_of(proofs.begin(), proofs.end(),
                     [](const Proof& proof) { return !proof.analysis.verdicts.empty(); });
}

}  // namespace pal::program
