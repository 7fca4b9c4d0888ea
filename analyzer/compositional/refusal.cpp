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

/// An event that is waited for in several places.
int event_of_many(const Problem& problem, const Segments& segments) {
  std::vector<int> waits(problem.channels.size());
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    if (problem.steps[s].kind != Step::Kind::wait || segments.owner(static_cast<int>(s)) < 0) continue;
    for (int channel : problem.steps[s].channels) ++waits[static_cast<std::size_t>(channel)];
  }
  for (const Device& device : problem.devices) {
    if (device.event >= 0 && waits[static_cast<std::size_t>(device.event)] > 1) return device.event;
  }
  return -1;
}

}  // namespace

std::string refusal_of(const Problem& problem, const Segments& segments) {
  const std::string talk = out_of_turn(problem, segments);
  if (!talk.empty()) return talk;
  const int event = event_of_many(problem, segments);
  if (event >= 0)
    return problem.channels[static_cast<std::size_t>(event)].message + " of " + sender_name(problem, event) +
           " is waited for in several places";
  for (std::size_t s = 0; s < problem.steps.size(); ++s) {
    const int thread = segments.owner(static_cast<int>(s));
    if (thread < 0) continue;
    if (problem.steps[s].kind == Step::Kind::wait && is_nested(problem, thread))
      return name_of(problem, thread) + " waits for messages in a block within a block";
    if (problem.steps[s].kind == Step::Kind::fork &&
        starts_rounds_again(problem, static_cast<int>(s), thread))
      return name_of(problem, thread) + " starts blocks again and again of which some go round";
  }
  return {};
}

}  // namespace pal::analyzer::compositional
