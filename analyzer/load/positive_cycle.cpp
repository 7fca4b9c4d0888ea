#include "analyzer/load/positive_cycle.hpp"

#include <algorithm>
#include <deque>

namespace pal::analyzer {

PositiveCycle::PositiveCycle(int nodes, std::vector<std::pair<int, int>> edges)
    : edges_(std::move(edges)), first_(static_cast<std::size_t>(nodes) + 1) {
  for (const auto& edge : edges_) ++first_[static_cast<std::size_t>(edge.first) + 1];
  for (std::size_t n = 1; n < first_.size(); ++n) first_[n] += first_[n - 1];
  order_.resize(edges_.size());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t e = 0; e < edges_.size(); ++e)
    order_[next[static_cast<std::size_t>(edges_[e].first)]++] = static_cast<int>(e);
}

std::vector<int> PositiveCycle::find(const std::vector<Gain>& gains) {
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
      const auto edge = static_cast<std::size_t>(order_[k]);
      const auto to = static_cast<std::size_t>(edges_[edge].second);
      if (distance_[node] + gains[edge] <= distance_[to]) continue;
      distance_[to] = distance_[node] + gains[edge];
      parent_[to] = order_[k];
      if (!queued[to]) {
        queued[to] = true;
        open.push_back(edges_[edge].second);
      }
      if (++relaxed % nodes == 0) {
        std::vector<int> cycle = in_parents();
        if (!cycle.empty()) return cycle;
      }
    }
  }
  return in_parents();
}

/// A cycle among the parent links is a positive one.
std::vector<int> PositiveCycle::in_parents() const {
  const std::size_t nodes = parent_.size();
  const auto before = [this](std::size_t node) {
    return static_cast<std::size_t>(edges_[static_cast<std::size_t>(parent_[node])].first);
  };
  std::vector<int> seen(nodes, -1);
  for (std::size_t start = 0; start < nodes; ++start) {
    std::size_t at = start;
    while (seen[at] < 0 && parent_[at] >= 0) {
      seen[at] = static_cast<int>(start);
      at = before(at);
    }
    if (parent_[at] < 0 || seen[at] != static_cast<int>(start)) {
      if (seen[at] < 0) seen[at] = static_cast<int>(start);
      continue;
    }
    std::vector<int> cycle;
    std::size_t around = at;
    do {
      cycle.push_back(parent_[around]);
      around = before(around);
    } while (around != at);
    std::reverse(cycle.begin(), cycle.end());
    return cycle;
  }
  return {};
}

}  // namespace pal::analyzer
