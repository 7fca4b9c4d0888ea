// Whether a file is UTF-8 text.
#pragma once

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal {

/// True for UTF-8 without NUL bytes. Otherwise the first wrong byte is reported.
bool report_unless_text(const SourceManager& sources, FileId file, Diagnostics& diagnostics);

}  // namespace pal
