#include "analyzer/compositional/causes/takers.hpp"

#include "analyzer/compositional/causes/protocol.hpp"

namespace pal::analyzer::compositional {

using Kind = Step::Kind;

Takers::Takers(const Problem& problem, const Segments& segments)
    : problem_(problem), takers_(problem.channels.size()), before_(problem.steps.size()) {
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    const Step& step = problem.steps[s];
    const int thread = segments.owner(static_cast<int>(s));
    if (thread < 0) continue;
    for (int next : step.next) before_[static_cast<std::size_t>(next)].push_back(static_cast<int>(s));
    if (step.kind != Kind::wait) continue;
    for (std::size_t arm = 0; arm < step.channels.size(); ++arm) {
      takers_[static_cast<std::size_t>(step.channels[arm])].push_back(
          {thread, static_cast<int>(s), static_cast<int>(arm)});
    }
  }
}

std::set<int> Takers::after(const std::vector<int>& sends) const {
  std::set<int> all;
  for (int send : sends) all.merge(takers_of_answer(problem_, send));
  return all;
}

bool Takers::last_taken_at(const std::vector<int>& steps, int request, int wait) const {
  std::set<int> seen;
  std::vector<int> open = steps;
  while (!open.empty()) {
    const int to = open.back();
    open.pop_back();
    if (!seen.insert(to).second) continue;
    for (int from : before_[static_cast<std::size_t>(to)]) {
      const Step& of = problem_.steps[static_cast<std::size_t>(from)];
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
