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

/// Whether a wait gives up waiting for a message of one of the channels `of`.
bool gives_up(const Step& wait, const std::vector<bool>& of) {
  return wait.within && std::any_of(wait.channels.begin(), wait.channels.end(),
                                    [&of](int channel) { return of[static_cast<std::size_t>(channel)]; });
}

/// By channel: whether several waits may take one message of it, nobody knows which.
std::vector<bool> taken_anywhere(const Problem& problem, const Segments& segments) {
  std::vector<bool> known = sequential_requests(problem);  // by channel: which wait takes the answer
  std::vector<int> waits(problem.channels.size());
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    const Step& step = problem.steps[s];
    if (segments.owner(static_cast<int>(s)) < 0) continue;
    for (int channel : step.channels) {
      const auto c = static_cast<std::size_t>(channel);
      if (step.kind == Step::Kind::wait) ++waits[c];
      if (step.kind != Step::Kind::send || problem.channels[c].answer < 0) continue;
      known[c] = known[c] && takers_of_answer(problem, static_cast<int>(s));
    }
  }
  std::vector<bool> anywhere(problem.channels.size());
  for (std::size_t c = 0; c < anywhere.size(); ++c) {
    const int request = problem.channels[c].answers;
    anywhere[c] = waits[c] > 1 && (request < 0 || !known[static_cast<std::size_t>(request)]);
  }
  return anywhere;
}

}  // namespace

std::string refusal_of(const Problem& problem, const Segments& segments) {
  const std::vector<bool> shared = shared_requests(problem);
  const std::vector<bool> withdrawn = withdrawn_requests(problem);
  const std::vector<bool> anywhere = taken_anywhere(problem, segments);
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    const int thread = segments.owner(static_cast<int>(s));
    if (thread < 0 || problem.steps[s].kind != Step::Kind::wait) continue;
    if (is_nested(problem, thread))
      return name_of(problem, thread) + " waits for messages in a block within a block";
    if (has_shared_limit(problem, problem.steps[s], shared))
      return name_of(problem, thread) + " may give up what a block beside it asks or waits for, too";
    // The limit counts anew when what the thread is about to take is withdrawn.
    if (gives_up(problem.steps[s], withdrawn))
      return name_of(problem, thread) + " waits with a limit for a request that may be withdrawn";
    // What it takes, those who wait for it elsewhere do not get.
    if (gives_up(problem.steps[s], anywhere))
      return name_of(problem, thread) + " waits with a limit for what may be taken elsewhere, too";
  }
  return {};
}

}  // namespace pal::analyzer::compositional
