#include "analyzer/cycle_ratio.hpp"

#include <algorithm>
#include <deque>

namespace pal::analyzer {
namespace {

__extension__ using Wide = __int128;

/// Finds a cycle with positive sum of work · scale - time · ratio, by longest paths from everywhere at once.
class PositiveCycle {
 public:
  PositiveCycle(int nodes, const std::vector<WeightedEdge>& edges)
      : edges_(edges), first_(static_cast<std::size_t>(nodes) + 1) {
    for (const WeightedEdge& edge : edges) ++first_[static_cast<std::size_t>(edge.from) + 1];
    for (std::size_t n = 1; n < first_.size(); ++n) first_[n] += first_[n - 1];
    order_.resize(edges.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t e = 0; e < edges.size(); ++e)
      order_[next[static_cast<std::size_t>(edges[e].from)]++] = static_cast<int>(e);
  }

  std::vector<int> find(std::int64_t work, std::int64_t time) {
    const std::size_t nodes = first_.size() - 1;
    distance_.assign(nodes, 0);
    parent_.assign(nodes, -1);
    std::vector<bool> queued(nodes, true);
    std::deque<int> open;
    for (std::size_t n = 0; n < nodes; ++n) open.push_back(static_cast<int>(n));
    std::size_t relaxed = 0;
    while (!open.empty()) {
      const auto node = static_cast<std::size_t>(open.front());
      open.pop_front();
      queued[node] = false;
      for (std::size_t k = first_[node]; k < first_[node + 1]; ++k) {
        const WeightedEdge& edge = edges_[static_cast<std::size_t>(order_[k])];
        const auto to = static_cast<std::size_t>(edge.to);
        const Wide gain = static_cast<Wide>(edge.work) * time - static_cast<Wide>(edge.time) * work;
        if (distance_[node] + gain <= distance_[to]) continue;
        distance_[to] = distance_[node] + gain;
        parent_[to] = order_[k];
        if (!queued[to]) {
          queued[to] = true;
          open.push_back(edge.to);
        }
        if (++relaxed % nodes == 0) {
          std::vector<int> cycle = in_parents();
          if (!cycle.empty()) return cycle;
        }
      }
    }
    return in_parents();
  }

 private:
  /// A cycle among the parent links is a positive one.
  std::vector<int> in_parents() const {
    const std::size_t nodes = parent_.size();
    std::vector<int> seen(nodes, -1);
    for (std::size_t start = 0; start < nodes; ++start) {
      std::size_t at = start;
      while (seen[at] < 0 && parent_[at] >= 0) {
        seen[at] = static_cast<int>(start);
        at = static_cast<std::size_t>(edges_[static_cast<std::size_t>(parent_[at])].from);
      }
      if (parent_[at] < 0 || seen[at] != static_cast<int>(start)) {
        if (seen[at] < 0) seen[at] = static_cast<int>(start);
        continue;
      }
      std::vector<int> cycle;
      std::size_t around = at;
      do {
        cycle.push_back(parent_[around]);
        around = static_cast<std::size_t>(edges_[static_cast<std::size_t>(parent_[around])].from);
      } while (around != at);
      std::reverse(cycle.begin(), cycle.end());
      return cycle;
    }
    return {};
  }

  const std::vector<WeightedEdge>& edges_;
  std::vector<std::size_t> first_;
  std::vector<int> order_;
  std::vector<Wide> distance_;
  std::vector<int> parent_;
};

}  // namespace

std::optional<CycleRatio> greatest_cycle_ratio(int nodes, const std::vector<WeightedEdge>& edges) {
  PositiveCycle search(nodes, edges);
  // A first cycle: any that takes time is better than less than nothing.
  CycleRatio best;
  best.work = -1;
  best.time = 1;
  for (;;) {
    const std::vector<int> cycle = search.find(best.work, best.time);
    if (cycle.empty()) break;
    std::int64_t work = 0;
    std::int64_t time = 0;
    for (int e : cycle) {
      work += edges[static_cast<std::size_t>(e)].work;
      time += edges[static_cast<std::size_t>(e)].time;
    }
    best = {work, time, cycle};
  }
  if (best.work < 0) return std::nullopt;
  return best;
}

}  // namespace pal::analyzer
