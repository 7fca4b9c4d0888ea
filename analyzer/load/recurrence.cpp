#include "analyzer/load/recurrence.hpp"

#include <algorithm>

namespace pal::analyzer {
namespace {

/// Strongly connected components (R. E. Tarjan, 1972), without recursion.
class Components {
 public:
  Components(std::size_t nodes, const std::vector<Edge>& edges)
      : next_(nodes), of_(nodes, -1), low_(nodes), number_(nodes, -1) {
    for (const Edge& edge : edges) next_[static_cast<std::size_t>(edge.from)].push_back(edge.to);
    for (std::size_t n = 0; n < nodes; ++n) {
      if (number_[n] < 0) visit(static_cast<int>(n));
    }
  }

  int of(int node) const { return of_[static_cast<std::size_t>(node)]; }
  int count() const { return count_; }

 private:
  void visit(int root) {
    std::vector<std::pair<int, std::size_t>> calls{{root, 0}};
    while (!calls.empty()) {
      const int node = calls.back().first;
      const auto n = static_cast<std::size_t>(node);
      if (calls.back().second == 0) {
        number_[n] = low_[n] = numbered_++;
        stack_.push_back(node);
      }
      bool descended = false;
      while (calls.back().second < next_[n].size()) {
        const int to = next_[n][calls.back().second++];
        const auto t = static_cast<std::size_t>(to);
        if (number_[t] < 0) {
          calls.emplace_back(to, 0);
          descended = true;
          break;
        }
        if (of_[t] < 0) low_[n] = std::min(low_[n], number_[t]);
      }
      if (descended) continue;
      if (low_[n] == number_[n]) {
        for (;;) {
          const int member = stack_.back();
          stack_.pop_back();
          of_[static_cast<std::size_t>(member)] = count_;
          if (member == node) break;
        }
        ++count_;
      }
      calls.pop_back();
      if (!calls.empty()) {
        const auto above = static_cast<std::size_t>(calls.back().first);
        low_[above] = std::min(low_[above], low_[n]);
      }
    }
  }

  std::vector<std::vector<int>> next_;
  std::vector<int> of_;
  std::vector<int> low_;
  std::vector<int> number_;
  std::vector<int> stack_;
  int numbered_ = 0;
  int count_ = 0;
};

}  // namespace

std::vector<Recurrence> recurrences(const ZoneGraph& graph) {
  const Components components(graph.classes().size(), graph.edges());
  std::vector<Recurrence> all(static_cast<std::size_t>(components.count()));
  std::vector<bool> repeats(all.size());
  std::vector<bool> entered(graph.classes().size());
  for (std::size_t e = 0; e < graph.edges().size(); ++e) {
    const Edge& edge = graph.edges()[e];
    const auto to = static_cast<std::size_t>(components.of(edge.to));
    if (components.of(edge.from) == components.of(edge.to)) {
      repeats[to] = true;
      all[to].edges.push_back(static_cast<int>(e));
    } else {
      entered[static_cast<std::size_t>(edge.to)] = true;
    }
  }
  for (std::size_t c = 0; c < graph.classes().size(); ++c) {
    if (graph.classes()[c].parent >= 0) continue;
    entered[static_cast<std::size_t>(graph.current(static_cast<int>(c)))] = true;
  }
  for (std::size_t c = 0; c < graph.classes().size(); ++c) {
    if (graph.classes()[c].replaced_by >= 0) continue;
    Recurrence& of = all[static_cast<std::size_t>(components.of(static_cast<int>(c)))];
    of.classes.push_back(static_cast<int>(c));
    if (entered[c]) of.entries.push_back(static_cast<int>(c));
  }
  std::vector<Recurrence> found;
  for (std::size_t r = 0; r < all.size(); ++r) {
    if (repeats[r]) found.push_back(std::move(all[r]));
  }
  return found;
}

}  // namespace pal::analyzer
