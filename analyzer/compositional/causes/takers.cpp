#include "analyzer/compositional/causes/takers.hpp"

#include "analyzer/compositional/causes/protocol.hpp"

namespace pal::analyzer::compositional {

using Kind = Step::Kind;

Takers::Takers(const Problem& problem, const Segments& segments)
    : problem_(problem), takers_(problem.channels.size()), before_(problem.steps.size()) {
  for (const StepId s : problem.steps.ids()) {
    const Step& step = problem.steps[s];
    const ThreadId thread = segments.owner(s);
    if (!thread.valid()) continue;
    for (StepId next : step.next) before_[next].push_back(s);
    if (step.kind != Kind::wait) continue;
    for (std::size_t arm = 0; arm < step.channels.size(); ++arm) {
      takers_[step.channels[arm]].push_back({thread, s, static_cast<int>(arm)});
    }
  }
}

std::set<StepId> Takers::after(const std::vector<StepId>& sends) const {
  std::set<StepId> all;
  for (StepId send : sends) all.merge(takers_of_answer(problem_, send));
  return all;
}

bool Takers::last_taken_at(const std::vector<StepId>& steps, ChannelId request, StepId wait) const {
  std::set<StepId> seen;
  std::vector<StepId> open = steps;
  while (!open.empty()) {
    const StepId to = open.back();
    open.pop_back();
    if (!seen.insert(to).second) continue;
    for (StepId from : before_[to]) {
      const Step& of = problem_.steps[from];
      bool other = of.kind != Kind::wait;  // ways from there that do not take a request
      for (std::size_t i = 0; i < of.next.size(); ++i) {
        if (of.kind != Kind::wait || of.next[i] != to) continue;
        const bool taken = i < of.channels.size() && of.channels[i] == request;
        if (taken && from != wait) return false;
        other = other || !taken;
      }
      if (other) open.push_back(from);
    }
  }
  return true;
}

}  // namespace pal::analyzer::compositional
