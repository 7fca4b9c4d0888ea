// Applies the fixes of findings.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pal/support/diagnostic.hpp"

namespace pal {

/// `text`, the text of `file`, with those of `edits` that are in it applied. Of edits that overlap only the
/// first is made.
std::string apply(std::vector<Edit> edits, FileId file, std::string_view text);

}  // namespace pal
