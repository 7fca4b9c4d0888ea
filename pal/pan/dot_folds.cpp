#include "pal/pan/dot_folds.hpp"

#include <algorithm>
#include <variant>

namespace pal::pan {

namespace {

/// How many nodes stand above each, on the longest way that leads there. Arms begin with their conditions.
std::vector<std::size_t> levels_of(const Graph& body) {
  std::vector<std::size_t> levels(body.nodes.size(), 0);
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const Node& node = body.nodes[i];
    const std::size_t step = std::holds_alternative<Choose>(node.content) ? 2 : 1;
    const auto follows = [&](std::size_t next) {
      if (next > i) levels[next] = std::max(levels[next], levels[i] + step);
    };
    for (const NodeId next : node.out) follows(next.index());
    if (node.mate.valid()) follows(node.mate.index());
    // What stands behind a loop that goes on for ever is drawn below it.
    if (node.out.empty() && i + 1 < body.nodes.size()) follows(i + 1);
  }
  return levels;
}

/// The nodes to which one way leads that is the only one across the text just before them.
std::vector<std::size_t> bridged(const Graph& body, const DotFlow& flow) {
  std::vector<int> across(body.nodes.size() + 1, 0);  // by node: ways from before it to it or behind it
  for (std::size_t i = 0; i < body.nodes.size(); ++i) {
    const auto leads = [&](std::size_t next, int ways) {
      if (next <= i) return;
      across[i + 1] += ways;
      across[next + 1] -= ways;
    };
    const Node& node = body.nodes[i];
    for (const NodeId next : node.out) leads(next.index(), 1);
    // Nothing is folded between the bars of a CONCURRENT, or within a CASE.
    const bool branches = !std::holds_alternative<Loop>(node.content) && node.mate.valid();
    if (branches) leads(node.mate.index(), 1);
  }
  std::vector<std::size_t> result;
  int ways = 0;
  for (std::size_t i = 1; i < body.nodes.size(); ++i) {
    ways += across[i];
    const bool straight = body.nodes[i - 1].out.size() == 1 && body.nodes[i - 1].out.front().index() == i;
    if (ways == 1 && straight && flow.drawn(i - 1) && flow.drawn(i) && flow.reached(i)) result.push_back(i);
  }
  return result;
}

}  // namespace

DotFolds::DotFolds(const Graph& body, const DotFlow& flow, std::size_t most)
    : begins_(body.nodes.size(), false), columns_(body.nodes.size(), 0) {
  if (body.nodes.empty()) return;
  const std::vector<std::size_t> levels = levels_of(body);
  const std::size_t height = *std::max_element(levels.begin(), levels.end()) + 1;
  if (height <= most) return;
  const std::size_t columns = (height + most - 1) / most;
  const std::size_t wanted = (height + columns - 1) / columns;
  std::size_t top = 0;   // the level at which the column begins
  std::size_t last = 0;  // a place to fold that was met since
  for (const std::size_t node : bridged(body, flow)) {
    if (levels[node] - top > wanted && last != 0) {
      begins_[last] = true;
      top = levels[last];
      last = 0;
    }
    if (levels[node] - top == wanted) {
      begins_[node] = true;
      top = levels[node];
      last = 0;
    } else if (levels[node] > top) {
      last = node;
    }
  }
  if (last != 0 && height - top > most) begins_[last] = true;
  for (std::size_t i = 1; i < columns_.size(); ++i) columns_[i] = columns_[i - 1] + (begins_[i] ? 1 : 0);
}

}  // namespace pal::pan
