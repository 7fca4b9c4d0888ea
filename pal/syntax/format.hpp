// The one canonical layout of PAL: of what people write, and of what is printed from trees.
#pragma once

#include <optional>
#include <string>

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal::syntax {

/// The text in canonical layout (docs/reference/formatting.md): the same words in the same order, keywords in
/// their canonical case, with every comment where it was among them. Formatting the result gives the result.
/// Of a text with lexical or syntax errors, which are reported: nothing.
std::optional<std::string> format(const SourceManager& sources, FileId file, Diagnostics& diagnostics);

}  // namespace pal::syntax
