#include "analyzer/compositional/causes/exclusive.hpp"

#include <map>
#include <tuple>

#include "analyzer/problem/flow.hpp"

namespace pal::analyzer::compositional {
namespace {

/// The wait that a round cannot pass without the next one having begun; -1: there is none. Who gives up there
/// goes on in the same round.
int end_of_round(const Ground& ground, int node) {
  const int round = ground.round_of(node);
  const Beginning& begins = ground.segment(round).beginning;
  if (begins.kind != Beginning::Kind::arm || ground.step_at(begins.step).within) return -1;
  return begins.step == ground.conduct_of(begins.thread).home ? begins.step : -1;
}

/// Whether a round that has passed `first` may come to another step.
bool may_follow(const Ground& ground, const Pass& first, int second) {
  const int end = end_of_round(ground, first.node);
  return follow(ground.problem, ground.step_at(first.step).next, [&](int at) {
    if (at == second) return Course::found;
    return at == end ? Course::ends : Course::goes_on;
  });
}

using Places = std::map<int, std::vector<int>>;

/// Whether a run of one node passes two of its steps.
bool any_in_node(const Ground& ground, const Places& steps_of) {
  std::map<std::tuple<int, int, int>, bool> known;  // by segment and steps
  for (const auto& [node, steps] : steps_of) {
    for (int first : steps) {
      for (int second : steps) {
        const auto [place, fresh] =
            known.emplace(std::tuple{ground.node(node).segment, first, second}, false);
        if (fresh) place->second = comes_after(ground.problem, ground.segment(node), first, second);
        if (place->second) return true;
      }
    }
  }
  return false;
}

/// Whether a run of the round passes a step in one node and then one in another.
bool any_in_round(const Ground& ground, const Places& nodes_of) {
  for (const auto& [first, nodes] : nodes_of) {
    for (const auto& [second, others] : nodes_of) {
      const bool one_node = nodes.size() == 1 && others == nodes;
      if (!one_node && may_follow(ground, {nodes.front(), first}, second)) return true;
    }
  }
  return false;
}

}  // namespace

bool are_exclusive(const Ground& ground, const std::vector<Pass>& passes) {
  Places steps_of;  // by node
  Places nodes_of;  // by step
  for (const Pass& pass : passes) {
    if (ground.round_of(pass.node) != ground.round_of(passes.front().node)) return false;
    steps_of[pass.node].push_back(pass.step);
    nodes_of[pass.step].push_back(pass.node);
  }
  return !any_in_node(ground, steps_of) && !any_in_round(ground, nodes_of);
}

}  // namespace pal::analyzer::compositional
