// The ways of a thread from step to step.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// What becomes of a way at a step: it goes on, it ends there, or the search has succeeded.
enum class Course { goes_on, ends, found };

/// Follows all ways from the steps `open`, these included, through each step once; returns whether the search
/// succeeded. `at` says what becomes of the way at the step with an index.
template <class At>
bool follow(const Problem& problem, std::vector<StepId> open, const At& at) {
  std::set<StepId> seen;
  while (!open.empty()) {
    const StepId step = open.back();
    open.pop_back();
    if (!seen.insert(step).second) continue;
    const Course way = at(step);
    if (way == Course::found) return true;
    if (way == Course::ends) continue;
    const std::vector<StepId>& next = problem.steps[step].next;
    open.insert(open.end(), next.begin(), next.end());
  }
  return false;
}

/// Visits each step that the flow reaches from `first`, as far as steps lead on (`leads_on`). Successors come
/// before their predecessors. In a cycle one of the steps comes first. Not recursive, because a module may
/// have thousands of statements in a row.
template <class LeadsOn, class Visit>
void backwards(const Problem& problem, StepId first, const LeadsOn& leads_on, const Visit& visit) {
  std::set<StepId> seen{first};
  std::vector<std::pair<StepId, std::size_t>> open{{first, 0}};
  while (!open.empty()) {
    const StepId step = open.back().first;
    const std::vector<StepId>& next = problem.steps[step].next;
    if (leads_on(step) && open.back().second < next.size()) {
      const StepId to = next[open.back().second++];
      if (seen.insert(to).second) open.emplace_back(to, 0);
      continue;
    }
    visit(step);
    open.pop_back();
  }
}

/// The steps of a thread, without those of its blocks.
inline std::set<StepId> steps_of(const Problem& problem, const Thread& thread) {
  std::set<StepId> steps;
  follow(problem, {thread.entry}, [&steps](StepId at) {
    steps.insert(at);
    return Course::goes_on;
  });
  return steps;
}

/// Whether a thread may come from a step back to it.
inline bool comes_back(const Problem& problem, StepId step) {
  return follow(problem, problem.steps[step].next,
                [step](StepId at) { return at == step ? Course::found : Course::goes_on; });
}

}  // namespace pal::analyzer
