// Segments of which only one can come: what they come from parts.
#pragma once

#include <functional>
#include <vector>

#include "analyzer/compositional/causes/forest.hpp"

namespace pal::analyzer::compositional {

/// Whether an occurrence of their source brings about one of the nodes at most: the ways to any two part at a
/// test, at a wait, or at a message that is taken in one of several places. Not of nodes of several sources.
bool are_alternatives(const Problem& problem, const Forest& forest, const std::vector<int>& nodes);

/// All nodes that have alternatives in their thread, in groups of such. No node is in two groups. Once `stop`
/// says so, those that are known by then.
std::vector<std::vector<int>> alternatives_of(const Problem& problem, const Forest& forest,
                                              const std::function<bool()>& stop);

/// By node: those on its processor, of whichever thread, that its source never has under way together with it
/// in one occurrence: they come in its place, or one is done before the other is released; ascending. Once
/// `stop` says so, those that are known by then.
std::vector<std::vector<int>> never_together(const Problem& problem, const Forest& forest,
                                             const std::function<bool()>& stop);

}  // namespace pal::analyzer::compositional
