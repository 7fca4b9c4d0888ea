// A module drawn as a graph (docs/pan.md) to tree: DOT is a second way to write one module.
#pragma once

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::syntax {

/// The files that `pal_uses` names and the module that the graph shows, every place being one of the DOT
/// text. Reports what is no DOT (PAL0114), nodes whose content is missing or makes no sense (PAL0115) and
/// ways that make no program (PAL0116). Never throws; after an error the tree is not `complete`.
Tree parse_dot(const SourceManager& sources, FileId file, Diagnostics& diagnostics);

}  // namespace pal::syntax
