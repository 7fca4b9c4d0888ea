#include "analyzer/verdict/unread.hpp"

#include "analyzer/machine/watch.hpp"

namespace pal::analyzer {
namespace {

bool reads(const Step& step, int condition) {
  return (step.kind == Step::Kind::read && step.condition == condition) || tests(step, condition);
}

/// By step: the flow of the thread leads to it.
std::vector<bool> flow_of(const Problem& problem, const Thread& thread) {
  std::vector<bool> found(problem.steps.size());
  std::vector<int> open{thread.entry};
  while (!open.empty()) {
    const auto here = static_cast<std::size_t>(open.back());
    open.pop_back();
    if (found[here]) continue;
    found[here] = true;
    const std::vector<int>& next = problem.steps[here].next;
    open.insert(open.end(), next.begin(), next.end());
  }
  return found;
}

}  // namespace

bool is_unread(const Problem& problem, const Requirement& requirement) {
  if (requirement.measure != Requirement::Measure::age || requirement.condition < 0) return false;
  std::vector<bool> read(problem.threads.size());  // by thread: it, or one whose block it is, reads
  for (std::size_t t = 0; t < problem.threads.size(); ++t) {
    const Thread& thread = problem.threads[t];
    const std::vector<bool> flow = flow_of(problem, thread);
    read[t] = thread.parent >= 0 && read[static_cast<std::size_t>(thread.parent)];
    bool comes = false;
    for (std::size_t s = 0; s < flow.size(); ++s) {
      if (!flow[s]) continue;
      read[t] = read[t] || reads(problem.steps[s], requirement.condition);
      comes = comes || requirement.at[s];
    }
    if (comes && read[t]) return false;
  }
  return true;
}

}  // namespace pal::analyzer
