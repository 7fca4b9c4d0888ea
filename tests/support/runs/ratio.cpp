#include "tests/support/runs/ratio.hpp"

#include <optional>

namespace pal::test {

namespace {

/// A cycle that does better than `than`: Bellman and Ford on work * time of `than` - time * its work.
std::optional<Ratio> better(std::size_t nodes, const std::vector<Stretch>& stretches, const Ratio& than) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::int64_t> gain(nodes, 0);
  std::vector<std::size_t> by(nodes, none);
  std::size_t changed = none;
  for (std::size_t round = 0; round <= nodes; ++round) {
    changed = none;
    for (std::size_t s = 0; s < stretches.size(); ++s) {
      const Stretch& each = stretches[s];
      const std::int64_t here = gain[each.from] + each.work * than.time - each.time * than.work;
      if (here <= gain[each.to]) continue;
      gain[each.to] = here;
      by[each.to] = s;
      changed = each.to;
    }
    if (changed == none) return std::nullopt;
    // Whether the ways that are known already go round: then there is no need for all the rounds.
    std::vector<std::size_t> seen(nodes, none);
    for (std::size_t start = 0; start < nodes; ++start) {
      std::size_t at = start;
      while (seen[at] == none && by[at] != none) {
        seen[at] = start;
        at = stretches[by[at]].from;
      }
      if (by[at] == none || seen[at] != start) continue;
      Ratio found{0, 0};
      const std::size_t first = at;
      do {
        found.work += stretches[by[at]].work;
        found.time += stretches[by[at]].time;
        at = stretches[by[at]].from;
      } while (at != first);
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace

Ratio greatest_ratio(std::size_t nodes, const std::vector<Stretch>& stretches) {
  Ratio greatest;
  while (const auto found = better(nodes, stretches, greatest)) greatest = *found;
  return greatest;
}

}  // namespace pal::test
