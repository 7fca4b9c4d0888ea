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

/// Blocks that are started again before nobody knows when, or stopped in each round.
bool starts_rounds_again(const Problem& problem, int fork, int thread) {
  const std::vector<int>& blocks = problem.steps[static_cast<std::size_t>(fork)].threads;
  const bool straight = std::all_of(blocks.begin(), blocks.end(), [&problem](int block) {
    return problem.threads[static_cast<std::size_t>(block)].can_end && ends_straight(problem, block);
  });
  return !straight && recurrent(problem, {Beginning::Kind::joined, thread, fork, -1});
}

/// Whether a wait gives up waiting for a message of one of the channels `of`.
bool gives_up(const Step& wait, const std::vector<bool>& of) {
  return wait.within && std::any_of(wait.channels.begin(), wait.channels.end(),
                                    [&of](int channel) { return of[static_cast<std::size_t>(channel)]; });
}

/// By channel: whether several waits may take one message of it, nobody knows which. Of an answer it is
/// known.
std::vector<bool> taken_anywhere(const Problem& problem, const Segments& segments) {
  std::vector<int> waits(problem.channels.size());
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    if (problem.steps[s].kind != Step::Kind::wait || segments.owner(static_cast<int>(s)) < 0) continue;
    for (int channel : problem.steps[s].channels) ++waits[static_cast<std::size_t>(channel)];
  }
  std::vector<bool> anywhere(problem.channels.size());
  for (std::size_t c = 0; c < anywhere.size(); ++c)
    anywhere[c] = waits[c] > 1 && problem.channels[c].answers < 0;
  return anywhere;
}

/// Why nothing can be said of a skill that has this step, or nothing.
std::string refusal_of_step(const Problem& problem, int index, int thread, const std::vector<bool>& withdrawn,
                            const std::vector<bool>& anywhere) {
  const Step& step = problem.steps[static_cast<std::size_t>(index)];
  const std::string& who = name_of(problem, thread);
  if (step.kind == Step::Kind::fork && starts_rounds_again(problem, index, thread))
    return who + " starts blocks again and again of which some go round";
  if (step.kind != Step::Kind::wait) return {};
  if (is_nested(problem, thread)) return who + " waits for messages in a block within a block";
  // The limit counts anew when what the thread is about to take is withdrawn.
  if (gives_up(step, withdrawn)) return who + " waits with a limit for a request that may be withdrawn";
  // What it takes, those who wait for it elsewhere do not get.
  if (gives_up(step, anywhere)) return who + " waits with a limit for what may be taken elsewhere, too";
  return {};
}

}  // namespace

std::string refusal_of(const Problem& problem, const Segments& segments) {
  const std::string talk = out_of_turn(problem, segments);
  if (!talk.empty()) return talk;
  const std::vector<bool> withdrawn = withdrawn_requests(problem);
  const std::vector<bool> anywhere = taken_anywhere(problem, segments);
  for (const Device& device : problem.devices) {
    if (device.event < 0 || !anywhere[static_cast<std::size_t>(device.event)]) continue;
    return problem.channels[static_cast<std::size_t>(device.event)].message + " of " + device.name +
           " is waited for in several places";
  }
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    const int step = static_cast<int>(s);
    const int thread = segments.owner(step);
    if (thread < 0) continue;
    const std::string why = refusal_of_step(problem, step, thread, withdrawn, anywhere);
    if (!why.empty()) return why;
  }
  return {};
}

}  // namespace pal::analyzer::compositional
