#include "analyzer/compositional/causes/sequence.hpp"

#include "analyzer/compositional/causes/job_distance.hpp"
#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {

Sequence::Sequence(const Problem& problem) : problem_(problem), started_by_(problem.threads.size(), -1) {
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    for (int block : problem.steps[s].threads)
      started_by_[static_cast<std::size_t>(block)] = static_cast<int>(s);
  }
}

const std::set<int>& Sequence::after(int step) {
  const auto [place, fresh] = after_.emplace(step, std::set<int>{});
  if (!fresh) return place->second;
  follow(problem_, problem_.steps[static_cast<std::size_t>(step)].next, [&](int at) {
    place->second.insert(at);
    return Course::goes_on;
  });
  return place->second;
}

int Sequence::fork_to(int thread, int block) const {
  for (int at = block; at >= 0; at = problem_.threads[static_cast<std::size_t>(at)].parent) {
    if (problem_.threads[static_cast<std::size_t>(at)].parent == thread)
      return started_by_[static_cast<std::size_t>(at)];
  }
  return -1;
}

bool Sequence::may_follow(const Beginning& earlier, const Beginning& later) {
  const Thread& first = problem_.threads[static_cast<std::size_t>(earlier.thread)];
  const Thread& second = problem_.threads[static_cast<std::size_t>(later.thread)];
  if (first.module != second.module) return true;
  const auto starts_again = [this](int thread) {
    const auto [place, fresh] = again_.emplace(thread, false);
    if (fresh) place->second = recurrent(problem_, {Beginning::Kind::entry, thread, -1, -1});
    return place->second;
  };
  if (starts_again(earlier.thread) || starts_again(later.thread)) return true;
  const int from = earlier.step < 0 ? first.entry : earlier.step;
  if (earlier.thread == later.thread) return later.step >= 0 && reaches(from, later.step);
  if (const int fork = fork_to(later.thread, earlier.thread); fork >= 0) {
    const bool joined = later.kind == Beginning::Kind::joined && later.step == fork;
    return joined || after(fork).contains(later.step);
  }
  if (const int fork = fork_to(earlier.thread, later.thread); fork >= 0) return reaches(from, fork);
  return true;
}

}  // namespace pal::analyzer::compositional
