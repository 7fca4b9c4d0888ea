#include "analyzer/verdict/unread.hpp"

#include "analyzer/machine/watch.hpp"
#include "analyzer/problem/flow.hpp"

namespace pal::analyzer {
namespace {

bool reads(const Step& step, ConditionId condition) {
  return (step.kind == Step::Kind::read && step.condition == condition) || tests(step, condition);
}

}  // namespace

bool is_unread(const Problem& problem, const Requirement& requirement) {
  if (requirement.measure != Requirement::Measure::age || !requirement.condition.valid()) return false;
  std::vector<bool> read(problem.threads.size());  // by thread: it, or one whose block it is, reads
  for (std::size_t t = 0; t < problem.threads.size(); ++t) {
    const Thread& thread = problem.threads[t];
    read[t] = thread.parent >= 0 && read[static_cast<std::size_t>(thread.parent)];
    bool comes = false;
    for (const int step : steps_of(problem, thread)) {
      const auto s = static_cast<std::size_t>(step);
      read[t] = read[t] || reads(problem.steps[s], requirement.condition);
      comes = comes || requirement.at[s];
    }
    if (comes && read[t]) return false;
  }
  return true;
}

}  // namespace pal::analyzer
