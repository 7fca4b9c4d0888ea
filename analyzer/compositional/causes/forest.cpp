#include "analyzer/compositional/causes/forest.hpp"

#include <algorithm>

namespace pal::analyzer::compositional {

using Kind = Step::Kind;

NodeId Forest::cause_in(NodeId node, ThreadId thread) const {
  for (NodeId at = nodes[node].cause; at.valid(); at = nodes[at].cause) {
    if (thread_of(at) == thread) return at;
  }
  return NodeId{};
}

bool end_segment(const Problem& problem, const std::vector<StepId>& sends) {
  return std::all_of(sends.begin(), sends.end(), [&problem](StepId send) {
    const StepId next = problem.steps[send].next.front();
    const Kind kind = problem.steps[next].kind;
    return kind == Kind::wait || kind == Kind::fork || kind == Kind::end;
  });
}

bool ends_with_cause(const Problem& problem, const Forest& forest, NodeId node) {
  const Node& of = forest.nodes[node];
  // Without a message it has come to a wait, or to its blocks.
  return of.release != Node::Release::message || end_segment(problem, of.sends);
}

Range latency(const Problem& problem, ChannelId channel, ThreadId sender, ThreadId receiver) {
  const Channel& of = problem.channels[channel];
  if (of.sender_device.valid() || of.receiver_device.valid()) return {};
  const bool same = problem.threads[sender].processor == problem.threads[receiver].processor;
  return same ? problem.within_processor : problem.between_processors;
}

}  // namespace pal::analyzer::compositional
