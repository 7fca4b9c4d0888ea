// Findings' fixes, carried out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pal/support/diagnostic.hpp"

namespace pal {

/// `text`, the text of `file`, after those of `edits` that are in it. Of edits that overlap the first is
/// made.
std::string apply(std::vector<Edit> edits, FileId file, std::string_view text);

}  // namespace pal
