// Text to tree.
#pragma once

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::syntax {

/// The deepest nesting of statements and parentheses that is parsed.
constexpr int deepest_nesting = 200;

/// Parses one file, reporting all its lexical and syntax errors, and figures that are no times or units.
/// Never throws; after a syntax error the tree holds what could be understood and is not `complete`.
Tree parse(const SourceManager& sources, FileId file, Diagnostics& diagnostics);

}  // namespace pal::syntax
