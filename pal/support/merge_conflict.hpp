// The lines that a merge leaves in a file where two versions could not be brought together.
#pragma once

#include <string_view>

#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"

namespace pal {

/// Whether `text`, the text of `file`, holds such lines. Reports one finding (PAL0119) at the first of them,
/// however many there are.
bool report_merge_conflict(std::string_view text, FileId file, Diagnostics& diagnostics);

}  // namespace pal
