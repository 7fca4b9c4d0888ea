#include "analyzer/problem/empty_rounds.hpp"

#include <vector>

#include "pal/support/diagnostic_code.hpp"

namespace pal::analyzer {
namespace {

const Step& step_at(const Problem& problem, int step) {
  return problem.steps[static_cast<std::size_t>(step)];
}

/// By step: a CONCURRENT in which some block can end, and those that can end have nothing to do. Blocks come
/// after their parents, so the innermost are known first.
std::vector<bool> over_at_once(const Problem& problem) {
  std::vector<bool> over(problem.steps.size());
  std::vector<bool> empty(problem.threads.size());  // by thread: it ends as soon as it begins
  std::vector<std::vector<int>> forks(problem.threads.size());
  for (std::size_t s = 0; s < over.size(); ++s) {
    const Step& step = problem.steps[s];
    if (step.kind != Step::Kind::fork || step.threads.empty()) continue;
    const int parent = problem.threads[static_cast<std::size_t>(step.threads.front())].parent;
    forks[static_cast<std::size_t>(parent)].push_back(static_cast<int>(s));
  }
  for (std::size_t t = problem.threads.size(); t-- > 0;) {
    for (int fork : forks[t]) {
      bool any = false;
      bool all = true;
      for (int block : step_at(problem, fork).threads) {
        if (!problem.threads[static_cast<std::size_t>(block)].can_end) continue;
        any = true;
        all = all && empty[static_cast<std::size_t>(block)];
      }
      over[static_cast<std::size_t>(fork)] = any && all;
    }
    if (!problem.threads[t].can_end) continue;  // else no circle leads away from its end
    int at = problem.threads[t].entry;
    while (over[static_cast<std::size_t>(at)]) at = step_at(problem, at).next.front();
    empty[t] = step_at(problem, at).kind == Step::Kind::end;
  }
  return over;
}

}  // namespace

void report_empty_rounds(const Problem& problem, Diagnostics& diagnostics) {
  const std::vector<bool> over = over_at_once(problem);
  std::vector<std::size_t> seen(over.size());  // by step: from which it was followed first, and one more
  for (std::size_t s = 0; s < over.size(); ++s) {
    auto at = s;
    while (over[at] && seen[at] == 0) {
      seen[at] = s + 1;
      at = static_cast<std::size_t>(problem.steps[at].next.front());
    }
    if (!over[at] || seen[at] != s + 1) continue;
    const StatementId statement = problem.steps[at].statement;
    diagnostics.report(Code::PAL0729, problem.statements[statement].where,
                       "nothing ever happens in the loop around these blocks",
                       "give the loop a wait or an activity");
  }
}

}  // namespace pal::analyzer
