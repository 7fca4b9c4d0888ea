#include "analyzer/compositional/causes/alternatives.hpp"

#include <algorithm>
#include <map>
#include <type_traits>

namespace pal::analyzer::compositional {
namespace {

using Release = Node::Release;

/// More pairs of nodes of one source than this are not looked at.
constexpr std::size_t most_alternative_pairs = 1'000'000;

bool too_many(const std::vector<int>& nodes) {
  return nodes.size() * nodes.size() > most_alternative_pairs;
}

/// Where the ways to nodes part.
class Ways {
 public:
  Ways(const Problem& problem, const Forest& forest) : problem_(problem), forest_(forest) {}

  /// Whether an occurrence of their source brings about one of two nodes at most.
  bool part(int one, int other) {
    const std::vector<int>& here = way_to(one);
    const std::vector<int>& there = way_to(other);
    const auto [at, beside] = std::mismatch(here.begin(), here.end(), there.begin(), there.end());
    if (at == here.begin() || at == here.end() || beside == there.end()) return false;
    return part_at_cause(node(*at), node(*beside));
  }

  /// Whether one of the causes of `node` is `before`, and has nothing more to do when the next one is
  /// released.
  bool comes_after(int node, int before) {
    const std::vector<int>& way = way_to(node);
    const auto at = std::find(way.begin(), way.end(), before);
    return at != way.end() && at + 1 != way.end() && ends_with_cause(problem_, forest_, *(at + 1));
  }

 private:
  const Node& node(int n) const { return forest_.nodes[static_cast<std::size_t>(n)]; }

  /// The causes of a node, from its source on, and itself.
  const std::vector<int>& way_to(int n) {
    const auto [known, fresh] = ways_.emplace(n, std::vector<int>());
    if (!fresh) return known->second;
    for (int at = n; at >= 0; at = node(at).cause) known->second.push_back(at);
    std::reverse(known->second.begin(), known->second.end());
    return known->second;
  }

  /// Whether a run of the cause of two nodes brings about one of them at most.
  bool part_at_cause(const Node& one, const Node& other) {
    if (one.release != other.release) return false;
    if (one.release == Release::limit) return true;  // it comes to one wait, which ends in one way
    if (one.release != Release::message) return false;
    const int cause = node(one.cause).segment;
    return std::all_of(one.sends.begin(), one.sends.end(), [&](StepId first) {
      return std::all_of(other.sends.begin(), other.sends.end(), [&](StepId second) {
        return first == second || !(in_row(cause, first, second) || in_row(cause, second, first));
      });
    });
  }

  bool in_row(int segment, StepId first, StepId second) {
    const auto [known, fresh] = after_.emplace(std::pair{segment, first}, Table<StepId, bool>());
    if (fresh) known->second = steps_after(problem_, forest_.segments[segment], first);
    return known->second[second];
  }

  const Problem& problem_;
  const Forest& forest_;
  std::map<int, std::vector<int>> ways_;                         // by node
  std::map<std::pair<int, StepId>, Table<StepId, bool>> after_;  // by segment and one of its sends
};

/// Nodes by source and what `key_of` says of them.
template <class KeyOf>
auto together_by(const Forest& forest, const KeyOf& key_of) {
  std::map<std::pair<std::invoke_result_t<KeyOf, int>, int>, std::vector<int>> together;
  for (std::size_t n = 0; n < forest.nodes.size(); ++n) {
    const int node = static_cast<int>(n);
    together[{key_of(node), forest.nodes[n].source}].push_back(node);
  }
  return together;
}

}  // namespace

bool are_alternatives(const Problem& problem, const Forest& forest, const std::vector<int>& nodes) {
  if (too_many(nodes)) return false;
  Ways ways(problem, forest);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (std::size_t before = 0; before < n; ++before) {
      if (!ways.part(nodes[n], nodes[before])) return false;
    }
  }
  return true;
}

std::vector<std::vector<int>> alternatives_of(const Problem& problem, const Forest& forest,
                                              const std::function<bool()>& stop) {
  const auto thread_of = [&](int node) { return forest.thread_of(node); };
  std::vector<std::vector<int>> all;
  for (const auto& [of, nodes] : together_by(forest, thread_of)) {
    if (too_many(nodes)) continue;
    Ways ways(problem, forest);
    std::vector<std::vector<int>> groups;
    for (int node : nodes) {
      if (stop && stop()) return all;
      const auto fits = [&](const std::vector<int>& group) {
        return std::all_of(group.begin(), group.end(), [&](int other) { return ways.part(node, other); });
      };
      const auto group = std::find_if(groups.begin(), groups.end(), fits);
      (group == groups.end() ? groups.emplace_back() : *group).push_back(node);
    }
    std::copy_if(groups.begin(), groups.end(), std::back_inserter(all),
                 [](const std::vector<int>& group) { return group.size() > 1; });
  }
  return all;
}

std::vector<std::vector<int>> never_together(const Problem& problem, const Forest& forest,
                                             const std::function<bool()>& stop) {
  const auto processor_of = [&](int node) { return problem.threads[forest.thread_of(node)].processor; };
  std::vector<std::vector<int>> all(forest.nodes.size());
  for (const auto& [of, nodes] : together_by(forest, processor_of)) {
    if (too_many(nodes)) continue;
    Ways ways(problem, forest);
    for (int one : nodes) {
      if (stop && stop()) return all;
      for (int other : nodes) {
        if (ways.part(one, other) || ways.comes_after(one, other) || ways.comes_after(other, one))
          all[static_cast<std::size_t>(one)].push_back(other);
      }
    }
  }
  return all;
}

}  // namespace pal::analyzer::compositional
