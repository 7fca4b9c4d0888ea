#include "analyzer/compositional/causes/since_cause.hpp"

#include <algorithm>

namespace pal::analyzer::compositional {

namespace {

/// Of more nodes, none is counted from a cause.
constexpr std::size_t most_counting = 2'000;

}  // namespace

int SinceCause::common(int one, int other) const {
  while (one >= 0 && other >= 0 && one != other) {
    // A cause stands before its effects.
    int& later = one > other ? one : other;
    later = context_.node(later).cause;
  }
  return one == other ? one : -1;
}

Nanoseconds SinceCause::least(int cause, int node) const {
  Nanoseconds time = 0;
  for (int at = node; at != cause && at >= 0; at = context_.node(at).cause)
    time = plus(time, earliest_after_cause(context_, at));
  return time;
}

/// The thread's own interference comes with its busy window, as that of other threads does.
bool SinceCause::counts(int node, int cause, const std::vector<bool>& known) const {
  const auto in_time = [&](int other) {
    const bool at_start =
        context_.source(other).kind == Source::Kind::start && context_.node(other).cause < 0;
    if (at_start && context_.segment(other).worst == 0) return true;  // over at time 0
    const std::vector<int>& later = order_->later[static_cast<std::size_t>(other)];
    return known[static_cast<std::size_t>(other)] || std::binary_search(later.begin(), later.end(), cause);
  };
  const Node& of = context_.node(node);
  if (of.cause < 0 || !known[static_cast<std::size_t>(of.cause)]) return false;
  if (context_.segment(node).beginning.kind == Beginning::Kind::joined) return false;
  const std::vector<int>& previous = context_.behaviours.previous[static_cast<std::size_t>(node)];
  if (!previous.empty()) return std::all_of(previous.begin(), previous.end(), in_time);
  if (of.release != Node::Release::message) return true;
  // The thread must be at its idle wait by then.
  const ThreadId thread = context_.forest.thread_of(node);
  const std::vector<int>& nodes = context_.behaviour_of(thread).nodes;
  const std::vector<int> endings = context_.endings_before_idle(thread);
  return std::all_of(nodes.begin(), nodes.end(),
                     [&](int other) {
                       return context_.source(other).period == never &&
                              (context_.in_job(other) || in_time(other));
                     }) &&
         std::all_of(endings.begin(), endings.end(), in_time);
}

std::vector<bool> SinceCause::counting_from(int cause) const {
  std::vector<bool> known(context_.forest.nodes.size());
  if (known.size() > most_counting || context_.source(cause).period != never) return known;
  known[static_cast<std::size_t>(cause)] = true;
  for (bool more = true; more;) {
    more = false;
    for (std::size_t n = static_cast<std::size_t>(cause) + 1; n < known.size(); ++n) {
      if (known[n] || !counts(static_cast<int>(n), cause, known)) continue;
      known[n] = true;
      more = true;
    }
  }
  return known;
}

bool SinceCause::counts_from(int cause, int node) {
  const auto [place, fresh] = counting_.try_emplace(cause);
  if (fresh) place->second = counting_from(cause);
  return place->second[static_cast<std::size_t>(node)];
}

}  // namespace pal::analyzer::compositional
