#include "analyzer/compositional/causes/since_cause.hpp"

#include <algorithm>

namespace pal::analyzer::compositional {

namespace {

/// Of more nodes, none is counted from a cause.
constexpr std::size_t most_counting = 2'000;

}  // namespace

NodeId SinceCause::common(NodeId one, NodeId other) const {
  while (one.valid() && other.valid() && one != other) {
    // A cause stands before its effects.
    NodeId& later = one > other ? one : other;
    later = context_.node(later).cause;
  }
  return one == other ? one : NodeId{};
}

Nanoseconds SinceCause::least(NodeId cause, NodeId node) const {
  Nanoseconds time = 0;
  for (NodeId at = node; at != cause && at.valid(); at = context_.node(at).cause)
    time = plus(time, earliest_after_cause(context_, at));
  return time;
}

/// The thread's own interference comes with its busy window, as that of other threads does.
bool SinceCause::counts(NodeId node, NodeId cause, const Table<NodeId, bool>& known) const {
  const auto in_time = [&](NodeId other) {
    const bool at_start =
        context_.source(other).kind == Source::Kind::start && !context_.node(other).cause.valid();
    if (at_start && context_.segment(other).worst == 0) return true;  // over at time 0
    const std::vector<NodeId>& later = order_->later[other];
    return known[other] || std::binary_search(later.begin(), later.end(), cause);
  };
  const Node& of = context_.node(node);
  if (!of.cause.valid() || !known[of.cause]) return false;
  if (context_.segment(node).beginning.kind == Beginning::Kind::joined) return false;
  const std::vector<NodeId>& previous = context_.behaviours.previous[node];
  if (!previous.empty()) return std::all_of(previous.begin(), previous.end(), in_time);
  if (of.release != Node::Release::message) return true;
  // The thread must be at its idle wait by then.
  const ThreadId thread = context_.forest.thread_of(node);
  const std::vector<NodeId>& nodes = context_.behaviour_of(thread).nodes;
  const std::vector<NodeId> endings = context_.endings_before_idle(thread);
  return std::all_of(nodes.begin(), nodes.end(),
                     [&](NodeId other) {
                       return context_.source(other).period == never &&
                              (context_.in_job(other) || in_time(other));
                     }) &&
         std::all_of(endings.begin(), endings.end(), in_time);
}

Table<NodeId, bool> SinceCause::counting_from(NodeId cause) const {
  Table<NodeId, bool> known(context_.forest.nodes.size());
  if (known.size() > most_counting || context_.source(cause).period != never) return known;
  known[cause] = true;
  for (bool more = true; more;) {
    more = false;
    for (NodeId n(cause.index() + 1); known.contains(n); n = NodeId(n.index() + 1)) {
      if (known[n] || !counts(n, cause, known)) continue;
      known[n] = true;
      more = true;
    }
  }
  return known;
}

bool SinceCause::counts_from(NodeId cause, NodeId node) {
  const auto [place, fresh] = counting_.try_emplace(cause);
  if (fresh) place->second = counting_from(cause);
  return place->second[node];
}

}  // namespace pal::analyzer::compositional
