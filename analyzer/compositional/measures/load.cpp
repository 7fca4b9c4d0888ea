// How much of its time a processor is busy.
#include <algorithm>

#include "analyzer/compositional/measures/measures.hpp"
#include "analyzer/load/fraction.hpp"
#include "analyzer/verdict/sentence.hpp"

namespace pal::analyzer::compositional {

namespace {

/// Nodes that need not come, since a longer one may come in their place.
Table<NodeId, bool> replaced_by_longer(const View& view) {
  const auto worst = [&view](NodeId n) { return view.forest.segment_of(view.forest.nodes[n]).worst; };
  Table<NodeId, bool> replaced(view.forest.nodes.size());
  for (const std::vector<NodeId>& alternatives : view.behaviours.alternatives) {
    const NodeId longest =
        *std::max_element(alternatives.begin(), alternatives.end(),
                          [&](NodeId one, NodeId other) { return worst(one) < worst(other); });
    for (NodeId n : alternatives) replaced[n] = n != longest;
  }
  return replaced;
}

}  // namespace

Bound load_bound(const View& view, const Requirement& requirement) {
  constexpr Nanoseconds second = 1'000'000'000;
  const Why whole_time = why(Withheld::rates_reach_all);
  const Sum whole(second, {Term::Kind::said, {}, {}, {}, whole_time.text});
  Table<ProcessorId, Sum> busy(view.problem.processors.size());
  const Table<NodeId, bool> replaced = replaced_by_longer(view);
  for (const NodeId n : view.forest.nodes.ids()) {
    const Node& node = view.forest.nodes[n];
    const Segment& segment = view.forest.segment_of(node);
    const Source& source = view.forest.sources[node.source];
    if (source.period == never || segment.worst == 0 || replaced[n]) continue;
    const ThreadId thread = segment.beginning.thread;
    Sum& sum = busy[view.problem.threads[thread].processor];
    // More than the whole time is the whole time.
    const Nanoseconds share =
        segment.worst < source.period ? per_second({segment.worst, source.period}) : second;
    const std::string what =
        "runs " + milliseconds(segment.worst) + " in each " + milliseconds(source.period);
    sum = sum + Sum(share, {Term::Kind::said, n, {}, {}, what});
    if (sum.value() >= second) sum = whole;
  }
  Sum most;
  for (ProcessorId processor : requirement.processors) most = greater(most, busy[processor]);
  return {most, most.value() == second ? whole_time : Why{}};
}

namespace {

Sum busy_without_pause(const View& view, ProcessorId processor) {
  const Nanoseconds busy = view.windows().busy(processor);
  if (busy >= never) return Sum::unbounded();
  Sum all;
  for (const Share& share : view.windows().work(processor, busy)) {
    const NodeId node = view.times.interference->node_of(share.transaction, share.task);
    const std::string what = share.jobs == 1 ? "runs" : "runs " + std::to_string(share.jobs) + " times";
    all = all + Sum(share.work, {Term::Kind::said, node, {}, {}, what});
  }
  return all;
}

}  // namespace

Bound busy_bound(const View& view, const Requirement& requirement) {
  Sum longest;
  for (ProcessorId processor : requirement.processors)
    longest = greater(longest, busy_without_pause(view, processor));
  return {longest, why(Withheld::work_without_end)};
}

}  // namespace pal::analyzer::compositional
