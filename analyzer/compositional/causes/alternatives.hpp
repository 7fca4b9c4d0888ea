// Mutually exclusive segments: of these, one occurrence of their source triggers at most one.
#pragma once

#include <functional>
#include <vector>

#include "analyzer/compositional/causes/forest.hpp"

namespace pal::analyzer::compositional {

/// Whether an occurrence of their source triggers at most one of the nodes. Then the paths to any two of them
/// branch. They branch at a test, at a wait, or at a message that is received in one of several places. False
/// for nodes of several sources.
bool are_alternatives(const Problem& problem, const Forest& forest, const std::vector<NodeId>& nodes);

/// Disjoint groups of mutually exclusive nodes of one thread. After `stop` has returned true, the groups
/// found so far.
std::vector<std::vector<NodeId>> alternatives_of(const Problem& problem, const Forest& forest,
                                                 const std::function<bool()>& stop);

/// By node, ascending: nodes of any thread on its processor that never overlap with it within one occurrence
/// of its source. They are mutually exclusive, or one is done before the other is released. After `stop` has
/// returned true, those found so far.
Table<NodeId, std::vector<NodeId>> never_together(const Problem& problem, const Forest& forest,
                                                  const std::function<bool()>& stop);

}  // namespace pal::analyzer::compositional
