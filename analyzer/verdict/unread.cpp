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
  Table<ThreadId, bool> read(problem.threads.size());  // by thread: it, or one whose block it is, reads
  for (const ThreadId t : problem.threads.ids()) {
    const Thread& thread = problem.threads[t];
    read[t] = thread.parent.valid() && read[thread.parent];
    bool comes = false;
    for (const StepId s : steps_of(problem, thread)) {
      read[t] = read[t] || reads(problem.steps[s], requirement.condition);
      comes = comes || requirement.at[s];
    }
    if (comes && read[t]) return false;
  }
  return true;
}

}  // namespace pal::analyzer
