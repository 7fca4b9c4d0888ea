#include "analyzer/compositional/times/excluded_work.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "analyzer/compositional/causes/alternatives.hpp"

namespace pal::analyzer::compositional {
namespace {

/// Of a processor with more nodes, no work is taken out as a whole.
constexpr std::size_t most_excluding = 2'000;

bool contains(const std::vector<int>& sorted, int node) {
  return std::binary_search(sorted.begin(), sorted.end(), node);
}

/// Takes out those that `moves` and hands them to `take`.
template <class Moves, class Take>
void move_if(std::vector<int>& nodes, const Moves& moves, const Take& take) {
  const auto from = std::stable_partition(nodes.begin(), nodes.end(), [&](int n) { return !moves(n); });
  const std::vector<int> moved(from, nodes.end());
  nodes.erase(from, nodes.end());
  for (const int n : moved) take(n);
}

}  // namespace

ExcludedWork::ExcludedWork(const AnalysisContext& context, std::shared_ptr<const Order> order,
                           const std::function<bool()>& stop)
    : context_(context),
      nodes_on_(context.problem.processors.size()),
      place_(context.forest.nodes.size()),
      after_(context.forest.nodes.size()),
      order_(std::move(order)),
      never_together_(never_together(context.problem, context.forest, stop)) {
  for (std::size_t n = 0; n < place_.size(); ++n) {
    std::vector<int>& here = nodes_on_[context.thread_of(static_cast<int>(n)).processor];
    place_[n] = here.size();
    here.push_back(static_cast<int>(n));
  }
  for (std::size_t n = 0; n < place_.size(); ++n) {
    const ProcessorId processor = context_.thread_of(static_cast<int>(n)).processor;
    if (nodes_on_[processor].size() <= most_excluding) after_[n] = set_of(processor, order_->later[n]);
  }
}

ExcludedWork::Bits ExcludedWork::set_of(ProcessorId processor, const std::vector<int>& nodes) const {
  Bits set((nodes_on_[processor].size() + 63) / 64);
  for (const int n : nodes) {
    if (context_.thread_of(n).processor != processor) continue;
    const std::size_t place = place_[static_cast<std::size_t>(n)];
    set[place / 64] |= std::uint64_t{1} << place % 64;
  }
  return set;
}

bool ExcludedWork::comes_later(int node, int other) const {
  return contains(order_->later[static_cast<std::size_t>(node)], other);
}

bool ExcludedWork::never_overlap(int node, int other, bool done_before_next, bool in_turn) const {
  const auto n = static_cast<std::size_t>(node);
  return (done_before_next && context_.forest.thread_of(other) == context_.forest.thread_of(node)) ||
         (in_turn && contains(never_together_[n], other)) || contains(order_->never_overlapping[n], other);
}

bool ExcludedWork::recurs(int node) const {
  return context_.source(node).period != never;
}

/// All of `before` is over before any of `set` is released.
bool ExcludedWork::is_before(int before, const Bits& set) const {
  const Bits& after = after_[static_cast<std::size_t>(before)];
  if (after.size() != set.size()) return false;
  for (std::size_t w = 0; w < set.size(); ++w) {
    if ((set[w] & ~after[w]) != 0) return false;
  }
  return true;
}

std::vector<int> ExcludedWork::of(int node, bool done_before_next, bool in_turn) const {
  const Thread& mine = context_.thread_of(node);
  std::vector<int> excluded;
  std::vector<int> over;       // before the node is released
  std::vector<int> apart;      // never at the same time as the node
  std::vector<int> recurring;  // counts, and may come again
  for (const int other : nodes_on_[mine.processor]) {
    if (other == node || context_.segment(other).worst == 0) continue;
    if (context_.thread_of(other).priority < mine.priority) continue;
    if (comes_later(node, other)) {
      excluded.push_back(other);
    } else if (contains(order_->later[static_cast<std::size_t>(other)], node)) {
      over.push_back(other);
    } else if (never_overlap(node, other, done_before_next, in_turn)) {
      apart.push_back(other);
    } else if (recurs(other)) {
      recurring.push_back(other);
    }
  }
  const bool preemptive = context_.problem.processors[mine.processor].preemptive;
  const auto count = [&](int other) {
    if (recurs(other)) recurring.push_back(other);
  };
  // What counts after all may keep other work from being left out.
  for (std::size_t known = recurring.size() + 1; known != recurring.size();) {
    known = recurring.size();
    const Bits after_all = set_of(mine.processor, recurring);
    move_if(
        over, [&](int other) { return !is_before(other, after_all); },
        [&](int other) {
          if (never_overlap(node, other, done_before_next, in_turn)) return apart.push_back(other);
          count(other);
        });
    int nearest = preemptive ? std::numeric_limits<int>::max() : mine.priority;  // least priority that counts
    for (const int each : recurring) nearest = std::min(nearest, context_.thread_of(each).priority);
    move_if(
        apart, [&](int other) { return context_.thread_of(other).priority >= nearest; }, count);
  }
  excluded.insert(excluded.end(), over.begin(), over.end());
  excluded.insert(excluded.end(), apart.begin(), apart.end());
  return excluded;
}

}  // namespace pal::analyzer::compositional
