// The canonical layout of PAL, for texts that people write and for texts printed from trees.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal::syntax {

/// The text in canonical layout (docs/reference/formatting.md). The words and their order are the same,
/// keywords have their canonical case, and every comment stays between the same words. Formatting the result
/// changes nothing. Nothing for a text with lexical or syntax errors, which are reported.
std::optional<std::string> format(const SourceManager& sources, FileId file, Diagnostics& diagnostics);

/// The edits of whole lines that lay out the lines that `within` touches. A text with errors is laid out
/// around them: a line with an error stays as it is. Where the lines beside it need it, its whole unit does.
std::vector<Edit> layout_edits(const SourceManager& sources, FileId file, const SourceSpan& within);

}  // namespace pal::syntax
