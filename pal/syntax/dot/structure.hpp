// From nodes and ways to statements inside one another.
#pragma once

#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/syntax/dot/contents.hpp"
#include "pal/syntax/dot/graph.hpp"
#include "pal/syntax/statement.hpp"

namespace pal::syntax {

/// The body that the graph shows; moves the statements out of `contents`. Edges that make no program are
/// reported (PAL0116; PAL0105 if nested too deeply); then it throws Reported.
Statements read_structure(const DotGraph& graph, DotContents& contents, Diagnostics& diagnostics);

}  // namespace pal::syntax
