#include "analyzer/compositional/causes/alternatives.hpp"

#include <algorithm>
#include <map>
#include <type_traits>

namespace pal::analyzer::compositional {
namespace {

using Release = Node::Release;

/// More pairs of nodes of one source than this are not looked at.
constexpr std::size_t most_alternative_pairs = 1'000'000;

bool too_many(const std::vector<NodeId>& nodes) {
  return nodes.size() * nodes.size() > most_alternative_pairs;
}

/// Where the ways to nodes part.
class Ways {
 public:
  Ways(const Problem& problem, const Forest& forest) : problem_(problem), forest_(forest) {}

  /// Whether an occurrence of their source brings about one of two nodes at most.
  bool part(NodeId one, NodeId other) {
    const std::vector<NodeId>& here = way_to(one);
    const std::vector<NodeId>& there = way_to(other);
    const auto [at, beside] = std::mismatch(here.begin(), here.end(), there.begin(), there.end());
    if (at == here.begin() || at == here.end() || beside == there.end()) return false;
    return part_at_cause(node(*at), node(*beside));
  }

  /// Whether one of the causes of `node` is `before`, and has nothing more to do when the next one is
  /// released.
  bool comes_after(NodeId node, NodeId before) {
    const std::vector<NodeId>& way = way_to(node);
    const auto at = std::find(way.begin(), way.end(), before);
    return at != way.end() && at + 1 != way.end() && ends_with_cause(problem_, forest_, *(at + 1));
  }

 private:
  const Node& node(NodeId n) const { return forest_.nodes[n]; }

  /// The causes of a node, from its source on, and itself.
  const std::vector<NodeId>& way_to(NodeId n) {
    const auto [known, fresh] = ways_.emplace(n, std::vector<NodeId>());
    if (!fresh) return known->second;
    for (NodeId at = n; at.valid(); at = node(at).cause) known->second.push_back(at);
    std::reverse(known->second.begin(), known->second.end());
    return known->second;
  }

  /// Whether a run of the cause of two nodes brings about one of them at most.
  bool part_at_cause(const Node& one, const Node& other) {
    if (one.release != other.release) return false;
    if (one.release == Release::limit) return true;  // it comes to one wait, which ends in one way
    if (one.release != Release::message) return false;
    const SegmentId cause = node(one.cause).segment;
    return std::all_of(one.sends.begin(), one.sends.end(), [&](StepId first) {
      return std::all_of(other.sends.begin(), other.sends.end(), [&](StepId second) {
        return first == second || !(in_row(cause, first, second) || in_row(cause, second, first));
      });
    });
  }

  bool in_row(SegmentId segment, StepId first, StepId second) {
    const auto [known, fresh] = after_.emplace(std::pair{segment, first}, Table<StepId, bool>());
    if (fresh) known->second = steps_after(problem_, forest_.segments[segment], first);
    return known->second[second];
  }

  const Problem& problem_;
  const Forest& forest_;
  std::map<NodeId, std::vector<NodeId>> ways_;                         // by node
  std::map<std::pair<SegmentId, StepId>, Table<StepId, bool>> after_;  // by segment and one of its sends
};

/// Nodes by source and what `key_of` says of them.
template <class KeyOf>
auto together_by(const Forest& forest, const KeyOf& key_of) {
  std::map<std::pair<std::invoke_result_t<KeyOf, NodeId>, SourceId>, std::vector<NodeId>> together;
  for (const NodeId n : forest.nodes.ids()) together[{key_of(n), forest.nodes[n].source}].push_back(n);
  return together;
}

}  // namespace

bool are_alternatives(const Problem& problem, const Forest& forest, const std::vector<NodeId>& nodes) {
  if (too_many(nodes)) return false;
  Ways ways(problem, forest);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (std::size_t before = 0; before < n; ++before) {
      if (!ways.part(nodes[n], nodes[before])) return false;
    }
  }
  return true;
}

std::vector<std::vector<NodeId>> alternatives_of(const Problem& problem, const Forest& forest,
                                                 const std::function<bool()>& stop) {
  const auto thread_of = [&](NodeId node) { return forest.thread_of(node); };
  std::vector<std::vector<NodeId>> all;
  for (const auto& [of, nodes] : together_by(forest, thread_of)) {
    if (too_many(nodes)) continue;
    Ways ways(problem, forest);
    std::vector<std::vector<NodeId>> groups;
    for (const NodeId node : nodes) {
      if (stop && stop()) return all;
      const auto fits = [&](const std::vector<NodeId>& group) {
        return std::all_of(group.begin(), group.end(), [&](NodeId other) { return ways.part(node, other); });
      };
      const auto group = std::find_if(groups.begin(), groups.end(), fits);
      (group == groups.end() ? groups.emplace_back() : *group).push_back(node);
    }
    std::copy_if(groups.begin(), groups.end(), std::back_inserter(all),
                 [](const std::vector<NodeId>& group) { return group.size() > 1; });
  }
  return all;
}

Table<NodeId, std::vector<NodeId>> never_together(const Problem& problem, const Forest& forest,
                                                  const std::function<bool()>& stop) {
  const auto processor_of = [&](NodeId node) { return problem.threads[forest.thread_of(node)].processor; };
  Table<NodeId, std::vector<NodeId>> all(forest.nodes.size());
  for (const auto& [of, nodes] : together_by(forest, processor_of)) {
    if (too_many(nodes)) continue;
    Ways ways(problem, forest);
    for (const NodeId one : nodes) {
      if (stop && stop()) return all;
      for (const NodeId other : nodes) {
        if (ways.part(one, other) || ways.comes_after(one, other) || ways.comes_after(other, one))
          all[one].push_back(other);
      }
    }
  }
  return all;
}

}  // namespace pal::analyzer::compositional
