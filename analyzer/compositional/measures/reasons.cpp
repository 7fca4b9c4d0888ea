#include "analyzer/compositional/measures/reasons.hpp"

namespace pal::analyzer::compositional {

std::string unbounded_reason_behind(const View& view, ThreadId thread) {
  std::vector<NodeId> open = view.behaviours.threads[thread].nodes;
  Table<NodeId, bool> seen(view.forest.nodes.size());
  if (!view.times.unbounded_reason[thread].empty()) return view.times.unbounded_reason[thread];
  for (std::size_t next = 0; next < open.size(); ++next) {
    const NodeId n = open[next];
    if (seen[n]) continue;
    seen[n] = true;
    const std::string& unbounded_reason = view.times.unbounded_reason[view.forest.thread_of(n)];
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
  return "";
}

std::string with_unbounded_reason(const std::string& what, const View& view, ThreadId thread) {
  const std::string behind = unbounded_reason_behind(view, thread);
  return behind.empty() ? what : what + ", since " + behind;
}

std::string why_not_again(const View& view, ThreadId thread, const StatementOccurrences& occurrences,
                          bool goes_on, const std::string& statement) {
  const ThreadId t = thread;
  if (!view.times.unbounded_reason[t].empty()) return view.times.unbounded_reason[t];
  const std::string& name = view.problem.threads[t].name;
  if (occurrences.may_skip()) return name + " need not come to " + statement + " in every job";
  const bool leaves = view.behaviours.threads[t].leaves;
  if (!goes_on && leaves && unbounded_reason_behind(view, thread).empty())
    return name + " may leave its loop";
  return with_unbounded_reason(goes_on ? "nothing bounds when " + name + " comes to " + statement
                                       : "nothing shows that " + name + " continues with its jobs",
                               view, thread);
}

}  // namespace pal::analyzer::compositional
