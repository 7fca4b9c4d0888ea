#include "analyzer/compositional/causes/alternatives.hpp"

#include <algorithm>
#include <map>

namespace pal::analyzer::compositional {
namespace {

using Release = Node::Release;

/// More pairs of nodes of one thread and source than this are not looked at.
constexpr std::size_t most_pairs = 1'000'000;

/// The causes of a node, from its source on, and itself.
using Way = std::vector<int>;

const Node& node_at(const Forest& forest, int node) {
  return forest.nodes[static_cast<std::size_t>(node)];
}

Way way_to(const Forest& forest, int node) {
  Way way;
  for (int at = node; at >= 0; at = node_at(forest, at).cause) way.push_back(at);
  std::reverse(way.begin(), way.end());
  return way;
}

/// Whether a run of the cause of two nodes brings about one of them at most.
bool part_at_cause(const Problem& problem, const Forest& forest, const Node& one, const Node& other) {
  if (one.release != other.release) return false;
  if (one.release == Release::limit) return true;  // it comes to one wait, which ends in one way
  if (one.release != Release::message) return false;
  const Segment& cause = forest.segment_of(node_at(forest, one.cause));
  return std::all_of(one.sends.begin(), one.sends.end(), [&](int first) {
    return std::all_of(other.sends.begin(), other.sends.end(), [&](int second) {
      const bool both =
          comes_after(problem, cause, first, second) || comes_after(problem, cause, second, first);
      return first == second || !both;
    });
  });
}

bool ways_part(const Problem& problem, const Forest& forest, const Way& one, const Way& other) {
  const auto [at, there] = std::mismatch(one.begin(), one.end(), other.begin(), other.end());
  if (at == one.begin() || at == one.end() || there == other.end()) return false;
  return part_at_cause(problem, forest, node_at(forest, *at), node_at(forest, *there));
}

}  // namespace

bool are_alternatives(const Problem& problem, const Forest& forest, const std::vector<int>& nodes) {
  if (nodes.size() * nodes.size() > most_pairs) return false;
  std::vector<Way> ways;
  for (int node : nodes) {
    const Way way = way_to(forest, node);
    const auto parts = [&](const Way& other) { return ways_part(problem, forest, way, other); };
    if (!std::all_of(ways.begin(), ways.end(), parts)) return false;
    ways.push_back(way);
  }
  return true;
}

std::vector<std::vector<int>> alternatives_of(const Problem& problem, const Forest& forest) {
  std::map<std::pair<int, int>, std::vector<int>> together;  // by thread and source
  for (std::size_t n = 0; n < forest.nodes.size(); ++n) {
    const int node = static_cast<int>(n);
    together[{forest.thread_of(node), forest.nodes[n].source}].push_back(node);
  }
  std::vector<std::vector<int>> all;
  for (const auto& [of, nodes] : together) {
    if (nodes.size() < 2 || nodes.size() * nodes.size() > most_pairs) continue;
    std::vector<std::vector<Way>> groups;
    for (int node : nodes) {
      Way way = way_to(forest, node);
      const auto parts = [&](const Way& other) { return ways_part(problem, forest, way, other); };
      const auto fits = [&](const std::vector<Way>& group) {
        return std::all_of(group.begin(), group.end(), parts);
      };
      const auto group = std::find_if(groups.begin(), groups.end(), fits);
      (group == groups.end() ? groups.emplace_back() : *group).push_back(std::move(way));
    }
    for (const auto& group : groups) {
      if (group.size() < 2) continue;
      std::vector<int>& made = all.emplace_back();
      for (const Way& way : group) made.push_back(way.back());
    }
  }
  return all;
}

std::vector<std::vector<int>> alternatives_to_each(const Problem& problem, const Forest& forest) {
  std::map<std::pair<int, int>, std::vector<int>> together;  // by processor and source
  for (std::size_t n = 0; n < forest.nodes.size(); ++n) {
    const int node = static_cast<int>(n);
    const auto thread = static_cast<std::size_t>(forest.thread_of(node));
    together[{problem.threads[thread].processor, forest.nodes[n].source}].push_back(node);
  }
  std::vector<std::vector<int>> all(forest.nodes.size());
  for (const auto& [of, nodes] : together) {
    if (nodes.size() * nodes.size() > most_pairs) continue;
    std::vector<Way> ways;
    for (int node : nodes) ways.push_back(way_to(forest, node));
    for (const Way& one : ways) {
      for (const Way& other : ways) {
        if (ways_part(problem, forest, one, other))
          all[static_cast<std::size_t>(one.back())].push_back(other.back());
      }
    }
  }
  return all;
}

}  // namespace pal::analyzer::compositional
