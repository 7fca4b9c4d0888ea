// Whether what was read is text at all.
#pragma once

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal {

/// True of UTF-8 without NUL bytes; of anything else the first byte that is wrong is reported.
bool report_unless_text(const SourceManager& sources, FileId file, Diagnostics& diagnostics);

}  // namespace pal
