// Skills of which nothing is said.
#include <algorithm>

#include "analyzer/compositional/forest.hpp"

namespace pal::analyzer::compositional {
namespace {

const std::string& name_of(const Problem& problem, int thread) {
  return problem.threads[static_cast<std::size_t>(thread)].name;
}

/// When a block within a block is there depends on rounds of several threads.
bool is_nested(const Problem& problem, int thread) {
  const int parent = problem.threads[static_cast<std::size_t>(thread)].parent;
  return parent >= 0 && problem.threads[static_cast<std::size_t>(parent)].parent >= 0;
}

/// A thread whose message is withdrawn while it takes it comes to its wait again: the limit counts anew.
bool has_shared_limit(const Problem& problem, const Step& wait, const std::vector<bool>& shared) {
  return wait.within && std::any_of(wait.channels.begin(), wait.channels.end(), [&](int channel) {
           const int request = problem.channels[static_cast<std::size_t>(channel)].answers;
           return request >= 0 && shared[static_cast<std::size_t>(request)];
         });
}

}  // namespace

std::string refusal_of(const Problem& problem, const Segments& segments) {
  const std::vector<bool> shared = shared_requests(problem);
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    const int thread = segments.owner(static_cast<int>(s));
    if (thread < 0 || problem.steps[s].kind != Step::Kind::wait) continue;
    if (is_nested(problem, thread))
      return name_of(problem, thread) + " waits for messages in a block within a block";
    if (has_shared_limit(problem, problem.steps[s], shared))
      return name_of(problem, thread) + " may give up what a block beside it asks or waits for, too";
  }
  return {};
}

}  // namespace pal::analyzer::compositional
