#include "analyzer/problem/empty_rounds.hpp"

#include <vector>

#include "pal/support/finding.hpp"

namespace pal::analyzer {
namespace {

const Step& step_at(const Problem& problem, StepId step) {
  return problem.steps[step];
}

/// The CONCURRENTs in which some block can end, and those that can end have nothing to do. Blocks come
/// after their parents, so the innermost are known first.
Table<StepId, bool> over_at_once(const Problem& problem) {
  Table<StepId, bool> over(problem.steps.size());
  Table<ThreadId, bool> empty(problem.threads.size());  // it ends as soon as it begins
  Table<ThreadId, std::vector<StepId>> forks(problem.threads.size());
  for (const StepId s : over.ids()) {
    const Step& step = problem.steps[s];
    if (step.kind != Step::Kind::fork || step.threads.empty()) continue;
    const ThreadId parent = problem.threads[step.threads.front()].parent;
    forks[parent].push_back(s);
  }
  for (std::size_t i = problem.threads.size(); i-- > 0;) {
    const ThreadId t(i);
    for (StepId fork : forks[t]) {
      bool any = false;
      bool all = true;
      for (ThreadId block : step_at(problem, fork).threads) {
        if (!problem.threads[block].can_end) continue;
        any = true;
        all = all && empty[block];
      }
      over[fork] = any && all;
    }
    if (!problem.threads[t].can_end) continue;  // else no circle leads away from its end
    StepId at = problem.threads[t].entry;
    while (over[at]) at = step_at(problem, at).next.front();
    empty[t] = step_at(problem, at).kind == Step::Kind::end;
  }
  return over;
}

}  // namespace

void report_empty_rounds(const Problem& problem, Diagnostics& diagnostics) {
  const Table<StepId, bool> over = over_at_once(problem);
  Table<StepId, StepId> seen(over.size());  // from which it was followed first
  for (const StepId s : over.ids()) {
    StepId at = s;
    while (over[at] && !seen[at].valid()) {
      seen[at] = s;
      at = problem.steps[at].next.front();
    }
    if (!over[at] || seen[at] != s) continue;
    const StatementId statement = problem.steps[at].statement;
    diagnostics.report(Finding::nothing_happens_around_blocks, problem.statements[statement].where);
  }
}

}  // namespace pal::analyzer
