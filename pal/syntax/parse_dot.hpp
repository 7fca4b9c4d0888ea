// A module drawn as a graph (docs/reference/pan.md) to tree: DOT is a second way to write one module.
#pragma once

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::syntax {

/// The files that `pal_uses` names and the module that the graph shows, every place being one of the DOT
/// text. Reports what is no DOT (PAL0114), nodes that say nothing that makes sense (PAL0115), ways that make
/// no program (PAL0116), attributes that mean nothing (PAL0117) and what a later pal wrote (PAL0118). Never
/// throws; after an error the tree is not `complete`.
Tree parse_dot(const SourceManager& sources, FileId file, Diagnostics& diagnostics);

}  // namespace pal::syntax
