#include "analyzer/verdict/refuted.hpp"

#include <algorithm>

namespace pal::analyzer {
namespace {

bool broken(const Verdict& verdict) {
  if (verdict.witness && verdict.witness->failed) return true;
  const std::optional<Duration> value = attained(verdict);
  return value && verdict.allowed().broken_by(*value);
}

/// `by`: the requirement for which a run was found.
void withdraw(Verdict& verdict, const std::string& by) {
  verdict.state = broken(verdict) ? VerdictState::fails : VerdictState::undecided;
  verdict.bound.reset();
  verdict.exact = false;
  verdict.addends.clear();
  verdict.explanation =
      "A run was found that contradicts what the " + std::string(name(verdict.method)) +
      " analysis proved of '" + by +
      "': that analysis is wrong for this skill, and nothing of it is used. Please report it.";
}

}  // namespace

bool is_refuted(const Verdict& verdict) {
  const bool unanswered = verdict.witness && verdict.witness->failed;
  const std::optional<Duration> value = attained(verdict);
  if (verdict.state == VerdictState::never) return unanswered || value;
  if (verdict.state == VerdictState::holds && broken(verdict)) return true;
  return verdict.bound && (unanswered || (value && verdict.allowed().worse(*value, *verdict.bound)));
}

void withdraw_refuted(const std::vector<Verdict>& proofs, std::vector<Verdict>& verdicts) {
  for (const Method method : {Method::exact, Method::compositional}) {
    const auto wrong = std::find_if(proofs.begin(), proofs.end(), [method](const Verdict& proof) {
      return proof.method == method && is_refuted(proof);
    });
    if (wrong == proofs.end()) continue;
    const std::string by = wrong->requirement;
    for (Verdict& verdict : verdicts) {
      if (verdict.method == method) withdraw(verdict, by);
    }
  }
}

void withdraw_refuted(std::vector<Verdict>& verdicts) {
  withdraw_refuted(verdicts, verdicts);
}

}  // namespace pal::analyzer
