#include "analyzer/compositional/times/excluded_work.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "analyzer/compositional/causes/alternatives.hpp"

namespace pal::analyzer::compositional {
namespace {

/// Of a processor with more nodes, no work is taken out as a whole.
constexpr std::size_t most_excluding = 2'000;

bool contains(const std::vector<NodeId>& sorted, NodeId node) {
  return std::binary_search(sorted.begin(), sorted.end(), node);
}

bool contains(const std::vector<std::uint64_t>& bits, std::size_t place) {
  return (bits[place / 64] >> place % 64 & 1) != 0;
}

/// Takes out those that `moves` and hands them to `take`.
template <class Moves, class Take>
void move_if(std::vector<NodeId>& nodes, const Moves& moves, const Take& take) {
  const auto from = std::stable_partition(nodes.begin(), nodes.end(), [&](NodeId n) { return !moves(n); });
  const std::vector<NodeId> moved(from, nodes.end());
  nodes.erase(from, nodes.end());
  for (const NodeId n : moved) take(n);
}

}  // namespace

ExcludedWork::ExcludedWork(const AnalysisContext& context, std::shared_ptr<const Order> order,
                           const std::function<bool()>& stop)
    : context_(context),
      nodes_on_(context.problem.processors.size()),
      workers_on_(context.problem.processors.size()),
      place_(context.forest.nodes.size()),
      after_(context.forest.nodes.size()),
      earlier_(context.forest.nodes.size()),
      order_(std::move(order)),
      never_together_(never_together(context.problem, context.forest, stop)) {
  for (const NodeId n : place_.ids()) {
    const Thread& thread = context.thread_of(n);
    std::vector<NodeId>& here = nodes_on_[thread.processor];
    place_[n] = here.size();
    here.push_back(n);
    if (context.segment(n).worst > 0)
      workers_on_[thread.processor].push_back({n, place_[n], thread.priority});
  }
  for (const NodeId n : place_.ids()) {
    const ProcessorId processor = context_.thread_of(n).processor;
    if (nodes_on_[processor].size() <= most_excluding) after_[n] = set_of(processor, order_->later[n]);
    for (const NodeId later : order_->later[n]) {
      if (context_.thread_of(later).processor == processor) earlier_[later].push_back(n);
    }
  }
}

ExcludedWork::Bits ExcludedWork::set_of(ProcessorId processor, const std::vector<NodeId>& nodes) const {
  Bits set((nodes_on_[processor].size() + 63) / 64);
  insert(processor, nodes, set);
  return set;
}

void ExcludedWork::insert(ProcessorId processor, const std::vector<NodeId>& nodes, Bits& set) const {
  for (const NodeId n : nodes) {
    if (context_.thread_of(n).processor != processor) continue;
    const std::size_t place = place_[n];
    set[place / 64] |= std::uint64_t{1} << place % 64;
  }
}

bool ExcludedWork::comes_later(NodeId node, NodeId other) const {
  return contains(order_->later[node], other);
}

bool ExcludedWork::never_overlap(NodeId node, NodeId other, bool done_before_next, bool in_turn) const {
  return (done_before_next && context_.forest.thread_of(other) == context_.forest.thread_of(node)) ||
         (in_turn && contains(never_together_[node], other)) ||
         contains(order_->never_overlapping[node], other);
}

bool ExcludedWork::recurs(NodeId node) const {
  return context_.source(node).period != never;
}

/// All of `before` is over before any of `set` is released.
bool ExcludedWork::is_before(NodeId before, const Bits& set) const {
  const Bits& after = after_[before];
  if (after.size() != set.size()) return false;
  for (std::size_t w = 0; w < set.size(); ++w) {
    if ((set[w] & ~after[w]) != 0) return false;
  }
  return true;
}

/// Nodes of its processor that may be left out; all others count.
ExcludedWork::Bits ExcludedWork::related(NodeId node, bool done_before_next, bool in_turn) const {
  const ProcessorId processor = context_.thread_of(node).processor;
  Bits set = set_of(processor, order_->later[node]);
  const auto add = [&](const std::vector<NodeId>& nodes) { insert(processor, nodes, set); };
  add(earlier_[node]);
  add(order_->never_overlapping[node]);
  if (in_turn) add(never_together_[node]);
  if (done_before_next) add(context_.behaviour_of(context_.forest.thread_of(node)).nodes);
  return set;
}

std::vector<NodeId> ExcludedWork::of(NodeId node, bool done_before_next, bool in_turn) const {
  const Thread& mine = context_.thread_of(node);
  std::vector<NodeId> excluded;
  std::vector<NodeId> over;   // before the node is released
  std::vector<NodeId> apart;  // never at the same time as the node
  const Bits related = this->related(node, done_before_next, in_turn);
  const std::vector<Worker>& workers = workers_on_[mine.processor];
  for (const auto& [other, place, priority] : workers) {
    if (!contains(related, place) || other == node || priority < mine.priority) continue;
    if (comes_later(node, other)) {
      excluded.push_back(other);
    } else if (comes_later(other, node)) {
      over.push_back(other);
    } else if (never_overlap(node, other, done_before_next, in_turn)) {
      apart.push_back(other);
    }
  }
  if (over.empty() && apart.empty()) return excluded;
  Bits left_out((nodes_on_[mine.processor].size() + 63) / 64);
  for (const auto* nodes : {&excluded, &over, &apart}) insert(mine.processor, *nodes, left_out);
  std::vector<NodeId> recurring;  // counts, and may come again
  for (const auto& [other, place, priority] : workers) {
    if (other == node || priority < mine.priority || contains(left_out, place)) continue;
    if (recurs(other)) recurring.push_back(other);
  }
  const bool preemptive = context_.problem.processors[mine.processor].preemptive;
  const auto count = [&](NodeId other) {
    if (recurs(other)) recurring.push_back(other);
  };
  // What counts after all may keep other work from being left out.
  for (std::size_t known = recurring.size() + 1; known != recurring.size();) {
    known = recurring.size();
    const Bits after_all = set_of(mine.processor, recurring);
    move_if(
        over, [&](NodeId other) { return !is_before(other, after_all); },
        [&](NodeId other) {
          if (never_overlap(node, other, done_before_next, in_turn)) return apart.push_back(other);
          count(other);
        });
    int nearest = preemptive ? std::numeric_limits<int>::max() : mine.priority;  // least priority that counts
    for (const NodeId each : recurring) nearest = std::min(nearest, context_.thread_of(each).priority);
    move_if(
        apart, [&](NodeId other) { return context_.thread_of(other).priority >= nearest; }, count);
  }
  excluded.insert(excluded.end(), over.begin(), over.end());
  excluded.insert(excluded.end(), apart.begin(), apart.end());
  return excluded;
}

}  // namespace pal::analyzer::compositional
