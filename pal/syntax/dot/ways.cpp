#include "pal/syntax/dot/ways.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "pal/support/finding.hpp"
#include "pal/syntax/dot/words.hpp"

namespace pal::syntax {

DotWays::DotWays(const DotGraph& graph, Diagnostics& diagnostics)
    : graph_(graph), diagnostics_(diagnostics), out_(graph.nodes.size()), back_(graph.nodes.size()) {
  for (const DotEdge& edge : graph.edges) {
    if (edge.values->is_true("pal_layout")) continue;
    (edge.values->is_true("pal_back") ? back_ : out_)[edge.from].push_back(&edge);
  }
}

std::size_t DotWays::only(std::size_t from) const {
  return single(from, out_[from]);
}

std::size_t DotWays::single(std::size_t from, const Edges& edges) const {
  if (edges.empty()) {
    diagnostics_.report(Finding::no_way_on, graph_.nodes[from].where);
    throw Reported{};
  }
  if (edges.size() > 1) {
    auto& finding = diagnostics_.report(Finding::second_edge, edges[1]->where);
    finding.note(edges[0]->where, Remark::first_one_here);
    throw Reported{};
  }
  return edges.front()->to;
}

std::vector<std::size_t> DotWays::branches(std::size_t from) const {
  std::vector<std::pair<std::int64_t, std::size_t>> order;
  for (const DotEdge* edge : out_[from]) {
    const DotValue* rank = edge->values->find("pal_branch");
    const auto place = static_cast<std::int64_t>(order.size());
    order.emplace_back(
        rank == nullptr ? place : DotWords(diagnostics_).number(*rank, std::numeric_limits<int>::max()),
        edge->to);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  if (order.empty()) {
    diagnostics_.report(Finding::no_branches, graph_.nodes[from].where);
    throw Reported{};
  }
  std::vector<std::size_t> result;
  for (const auto& entry : order) result.push_back(entry.second);
  return result;
}

bool DotWays::closes(std::size_t repeat, std::size_t until) const {
  const auto leads_to = [](const Edges& edges, std::size_t to) {
    return std::any_of(edges.begin(), edges.end(), [&](const DotEdge* edge) { return edge->to == to; });
  };
  return leads_to(out_[until], repeat) || leads_to(back_[until], repeat) || leads_to(back_[repeat], until);
}

std::optional<std::size_t> DotWays::behind_loop(std::size_t repeat, std::size_t until, bool forever) const {
  if (!closes(repeat, until)) {
    auto& finding = diagnostics_.report(Finding::no_way_back_to_repeat, graph_.nodes[until].where);
    finding.note(graph_.nodes[repeat].where, Remark::loop_begins);
    throw Reported{};
  }
  Edges on = out_[until];
  std::erase_if(on, [&](const DotEdge* edge) { return edge->to == repeat; });
  if (!forever) return single(until, on);
  for (const DotEdge* edge : on) {
    if (edge->values->is_true("pal_stops") || edge->values->is_true("pal_never_taken")) continue;
    diagnostics_.report(Finding::nothing_follows_endless_loop, edge->where);
    throw Reported{};
  }
  if (on.empty()) return std::nullopt;
  return single(until, on);
}

}  // namespace pal::syntax
