// The nodes of a PAN one by one: the content of each, before the edges are looked at.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/syntax/dot/graph.hpp"
#include "pal/syntax/statement.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::syntax {

/// What the nodes of a graph say, in the order of DotGraph::nodes.
struct DotContents {
  std::vector<std::string> kinds;
  std::vector<Statement> statements;         // of the kinds that are statements; without what is inside them
  std::vector<std::optional<Guard>> guards;  // of kinds guard and until
  std::vector<ActivityHeading> activities;   // that the graph names, and that nodes perform
};

/// Reads every node. Throws Reported if some node could not be read, after all of them were looked at.
DotContents read_contents(const DotGraph& graph, Diagnostics& diagnostics);

}  // namespace pal::syntax
