// Reading the files of a specification.
#pragma once

#include <string>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/support/file_system.hpp"
#include "pal/support/source.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

/// Reads and parses `paths` and all files that they use, each once, also if it has several names. Adds their
/// texts to `sources`. Reports files that cannot be read or are not text, circles of USES, and every syntax
/// error. A file that cannot be read is reported at the USES that names it, or else at its own beginning.
/// Returns the trees of the files named first, in their order, then those of the files they use, with
/// Uses::file filled in.
std::vector<syntax::Tree> read_sources(const FileSystem& files, SourceManager& sources,
                                       const std::vector<std::string>& paths, Diagnostics& diagnostics);

}  // namespace pal::check
