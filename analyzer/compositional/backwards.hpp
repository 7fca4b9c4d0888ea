// What follows first: values of steps that depend on those of the steps after them.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer::compositional {

/// Visits each step that the flow comes to from `first`, as far as steps lead on (`leads_on`), those that
/// follow a step before itself; in a circle one of them comes first. A module may have thousands of
/// statements in a row, more than calls may stand within one another.
template <class LeadsOn, class Visit>
void backwards(const Problem& problem, int first, const LeadsOn& leads_on, const Visit& visit) {
  std::set<int> seen{first};
  std::vector<std::pair<int, std::size_t>> open{{first, 0}};
  while (!open.empty()) {
    const int step = open.back().first;
    const std::vector<int>& next = problem.steps[static_cast<std::size_t>(step)].next;
    if (leads_on(step) && open.back().second < next.size()) {
      const int to = next[open.back().second++];
      if (seen.insert(to).second) open.emplace_back(to, 0);
      continue;
    }
    visit(step);
    open.pop_back();
  }
}

}  // namespace pal::analyzer::compositional
