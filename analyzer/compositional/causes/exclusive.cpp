#include "analyzer/compositional/causes/exclusive.hpp"

#include <algorithm>
#include <map>

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

/// Whether a round that has passed `first` may come to `second`.
bool may_follow(const Ground& ground, const Pass& first, const Pass& second) {
  const int end = end_of_round(ground, first.node);
  return follow(ground.problem, ground.step_at(first.step).next, [&](int at) {
    if (at == second.step) return Course::found;
    return at == end ? Course::ends : Course::goes_on;
  });
}

}  // namespace

bool are_exclusive(const Ground& ground, const std::vector<Pass>& passes) {
  std::map<std::pair<int, int>, bool> in_round;  // by steps
  const auto both = [&](const Pass& first, const Pass& second) {
    if (first.node == second.node)
      return comes_after(ground.problem, ground.segment(first.node), first.step, second.step);
    const auto [known, fresh] = in_round.emplace(std::pair{first.step, second.step}, false);
    if (fresh) known->second = may_follow(ground, first, second);
    return known->second;
  };
  return std::all_of(passes.begin(), passes.end(), [&](const Pass& first) {
    return ground.round_of(first.node) == ground.round_of(passes.front().node) &&
           std::none_of(passes.begin(), passes.end(),
                        [&](const Pass& second) { return both(first, second); });
  });
}

}  // namespace pal::analyzer::compositional
