// What cannot be under way yet when a segment runs.
#pragma once

#include "analyzer/compositional/ground.hpp"

namespace pal::analyzer::compositional {

/// By node, ascending: the nodes whose work is never there before the node is done, in no run. By the order
/// of a module's program; and what goes round only once something that comes once in a skill's life has
/// brought it about.
std::vector<std::vector<int>> come_later(const Ground& ground);

/// Whether the node's cause has nothing more to do once it has brought the node about.
bool ends_with_cause(const Ground& ground, int node);

}  // namespace pal::analyzer::compositional
