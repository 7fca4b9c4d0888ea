// An operation with the files of its sub-operations.
#pragma once

#include <optional>
#include <string>

#include "operations/model.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/support/file_system.hpp"
#include "pal/support/source.hpp"

namespace pal::operations {

/// Reads `path` and every file that a hierarchical icon names, each once; adds their texts to `sources`.
/// Reports what parse() does, and files that cannot be read (PAL0111). Nothing if `path` holds no operation.
std::optional<Program> load(const FileSystem& files, SourceManager& sources, const std::string& path,
                            Diagnostics& diagnostics);

}  // namespace pal::operations
