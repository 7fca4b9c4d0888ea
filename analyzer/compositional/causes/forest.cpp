#include "analyzer/compositional/causes/forest.hpp"

#include <algorithm>

namespace pal::analyzer::compositional {

using Kind = Step::Kind;

int Forest::cause_in(int node, int thread) const {
  for (int at = nodes[static_cast<std::size_t>(node)].cause; at >= 0;
       at = nodes[static_cast<std::size_t>(at)].cause) {
    if (thread_of(at) == thread) return at;
  }
  return -1;
}

bool end_segment(const Problem& problem, const std::vector<int>& sends) {
  return std::all_of(sends.begin(), sends.end(), [&problem](int send) {
    const int next = problem.steps[static_cast<std::size_t>(send)].next.front();
    const Kind kind = problem.steps[static_cast<std::size_t>(next)].kind;
    return kind == Kind::wait || kind == Kind::fork || kind == Kind::end;
  });
}

bool ends_with_cause(const Problem& problem, const Forest& forest, int node) {
  const Node& of = forest.nodes[static_cast<std::size_t>(node)];
  // Without a message it has come to a wait, or to its blocks.
  return of.release != Node::Release::message || end_segment(problem, of.sends);
}

Range latency(const Problem& problem, int channel, int sender, int receiver) {
  const Channel& of = problem.channels[static_cast<std::size_t>(channel)];
  if (of.sender_device.valid() || of.receiver_device.valid()) return {};
  const bool same = problem.threads[static_cast<std::size_t>(sender)].processor ==
                    problem.threads[static_cast<std::size_t>(receiver)].processor;
  return same ? problem.within_processor : problem.between_processors;
}

}  // namespace pal::analyzer::compositional
