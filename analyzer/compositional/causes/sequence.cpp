#include "analyzer/compositional/causes/sequence.hpp"

#include "analyzer/compositional/causes/job_distance.hpp"
#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {

Sequence::Sequence(const Problem& problem) : problem_(problem), started_by_(problem.threads.size()) {
  for (const StepId s : problem.steps.ids()) {
    for (ThreadId block : problem.steps[s].threads) started_by_[block] = s;
  }
}

const std::set<StepId>& Sequence::after(StepId step) {
  const auto [place, fresh] = after_.emplace(step, std::set<StepId>{});
  if (!fresh) return place->second;
  follow(problem_, problem_.steps[step].next, [&](StepId at) {
    place->second.insert(at);
    return Course::goes_on;
  });
  return place->second;
}

StepId Sequence::fork_to(ThreadId thread, ThreadId block) const {
  for (ThreadId at = block; at.valid(); at = problem_.threads[at].parent) {
    if (problem_.threads[at].parent == thread) return started_by_[at];
  }
  return StepId{};
}

bool Sequence::may_follow(const Beginning& earlier, const Beginning& later) {
  const Thread& first = problem_.threads[earlier.thread];
  const Thread& second = problem_.threads[later.thread];
  if (first.module != second.module) return true;
  const auto starts_again = [this](ThreadId thread) {
    const auto [place, fresh] = again_.emplace(thread, false);
    if (fresh) place->second = recurrent(problem_, {Beginning::Kind::entry, thread, {}, -1});
    return place->second;
  };
  if (starts_again(earlier.thread) || starts_again(later.thread)) return true;
  const StepId from = !earlier.step.valid() ? first.entry : earlier.step;
  if (earlier.thread == later.thread) return later.step.valid() && reaches(from, later.step);
  if (const StepId fork = fork_to(later.thread, earlier.thread); fork.valid()) {
    const bool joined = later.kind == Beginning::Kind::joined && later.step == fork;
    return joined || after(fork).contains(later.step);
  }
  if (const StepId fork = fork_to(earlier.thread, later.thread); fork.valid()) return reaches(from, fork);
  return true;
}

}  // namespace pal::analyzer::compositional
