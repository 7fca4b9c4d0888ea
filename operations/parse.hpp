// One file of operations, .op.json (docs/reference/operations.md).
#pragma once

#include <optional>

#include "operations/model.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal::operations {

/// Reads the text of `file`. Reports text that is not JSON (PAL1001) and fields that are missing, unknown or
/// of the wrong type (PAL1002), and goes on with the rest. Nothing if there is no operation at all.
std::optional<Document> parse(const SourceManager& sources, FileId file, Diagnostics& diagnostics);

}  // namespace pal::operations
