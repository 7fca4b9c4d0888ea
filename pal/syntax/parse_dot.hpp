// A module drawn as a graph (docs/reference/pan.md) to tree: DOT is a second way to write one module.
#pragma once

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::syntax {

/// The files that `pal_uses` names, and the module that the graph shows. All places are in the DOT text.
/// Reports text that is not DOT (PAL0114), nodes that make no sense (PAL0115) and edges that make no program
/// (PAL0116). Also reports unknown attributes (PAL0117) and unknown formats (PAL0118). Never throws; after an
/// error the tree is not `complete`.
Tree parse_dot(const SourceManager& sources, FileId file, Diagnostics& diagnostics);

}  // namespace pal::syntax
