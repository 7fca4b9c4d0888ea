// The parts of a skill's runs that can go on for ever.
#pragma once

#include <vector>

#include "analyzer/zones/zone_graph.hpp"

namespace pal::analyzer {

/// A strongly connected part of a zone graph, with at least one edge.
struct Recurrence {
  std::vector<int> classes;
  std::vector<int> entries;  // classes that are reached from outside, or that the skill begins in
  std::vector<int> edges;    // of the graph, inside
};

std::vector<Recurrence> recurrences(const ZoneGraph& graph);

}  // namespace pal::analyzer
