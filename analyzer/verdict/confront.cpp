#include "analyzer/verdict/confront.hpp"

#include <utility>

#include "analyzer/verdict/sentence.hpp"
#include "analyzer/verdict/story.hpp"

namespace pal::analyzer {
namespace {

bool beyond(const Requirement& requirement, const Witness& witness) {
  return witness.failed || requirement.allowed().broken_by(witness.measured.value);
}

bool says_more(const Requirement& requirement, const Witness& found, const std::optional<Witness>& known) {
  if (!known || found.failed) return true;
  if (known->failed || known->grows) return false;
  return requirement.allowed().worse(found.measured.value, known->measured.value);
}

}  // namespace

bool attains(const Verdict& verdict) {
  const auto& witness = verdict.witness;
  return verdict.bound && witness && !witness->failed && !witness->grows &&
         verdict.measure != Requirement::Measure::load && witness->measured.value == verdict.bound->count();
}

void confront(const Problem& problem, const Requirement& requirement, Witness found, Verdict& verdict) {
  if (!says_more(requirement, found, verdict.witness)) return;
  const bool fails = beyond(requirement, found);
  verdict.witness = std::move(found);
  verdict.reasons = reasons(problem, requirement, *verdict.witness);
  if (fails) verdict.state = Verdict::State::fails;
  verdict.exact = attains(verdict) || verdict.witness->failed;
  if (verdict.witness->failed) verdict.bound.reset();
  if (fails || verdict.exact) verdict.explanation = explanation(problem, requirement, verdict);
}

}  // namespace pal::analyzer
