// How wide text stands in a terminal, so that a caret stands below what it means.
#pragma once

#include <string>
#include <string_view>

namespace pal {

/// Columns that a code point takes: 0 for marks that combine with the one before, 2 for East Asian wide ones,
/// else 1.
int width(char32_t code_point);

/// Columns that `text` takes when it begins at column 0; a tab goes to the next multiple of 4.
int width(std::string_view text);

/// `text` with tabs as spaces and with what a terminal would act on (controls, broken UTF-8) as U+FFFD.
/// Has the width that width(text) says.
std::string printable(std::string_view text);

}  // namespace pal
