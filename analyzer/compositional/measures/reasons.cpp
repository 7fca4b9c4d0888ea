#include "analyzer/compositional/measures/reasons.hpp"

#include <utility>

namespace pal::analyzer::compositional {

Why unbounded_reason_behind(const View& view, ThreadId thread) {
  std::vector<NodeId> open = view.behaviours.threads[thread].nodes;
  Table<NodeId, bool> seen(view.forest.nodes.size());
  if (!view.times.unbounded_reason[thread].empty()) return view.times.unbounded_reason[thread];
  for (std::size_t next = 0; next < open.size(); ++next) {
    const NodeId n = open[next];
    if (seen[n]) continue;
    seen[n] = true;
    const Why& unbounded_reason = view.times.unbounded_reason[view.forest.thread_of(n)];
    if (!unbounded_reason.empty()) return unbounded_reason;
    const Node& node = view.forest.nodes[n];
    if (node.cause.valid()) {
      open.push_back(node.cause);
      continue;
    }
    for (const Source::Feed& feed : view.forest.sources[node.source].feeds) {
      if (feed.node.valid()) open.push_back(feed.node);
    }
  }
  return {};
}

Why with_unbounded_reason(Why what, const View& view, ThreadId thread) {
  return since(std::move(what), unbounded_reason_behind(view, thread));
}

Why why_not_one(const View& view, const std::set<ThreadId>& threads) {
  if (threads.empty()) return why(Withheld::no_thread_comes);
  if (threads.size() > 1 && view.withholds(Withheld::several_threads)) return why(Withheld::several_threads);
  return {};
}

Why why_not_again(const View& view, ThreadId thread, const StatementOccurrences& occurrences, bool goes_on,
                  const std::string& statement) {
  const ThreadId t = thread;
  if (!view.times.unbounded_reason[t].empty()) return view.times.unbounded_reason[t];
  const std::string& name = view.problem.threads[t].name;
  if (occurrences.may_skip()) return why(Withheld::may_skip, name, statement);
  const bool leaves = view.behaviours.threads[t].leaves;
  if (!goes_on && leaves && unbounded_reason_behind(view, thread).empty())
    return why(Withheld::may_leave_loop, name);
  return with_unbounded_reason(
      goes_on ? why(Withheld::not_known_when, name, statement) : why(Withheld::may_stop, name), view, thread);
}

}  // namespace pal::analyzer::compositional
