// The width of text in a terminal, so that a caret stands below the right character.
#pragma once

#include <string>
#include <string_view>

namespace pal {

/// Columns that a code point takes: 0 for marks that combine with the one before, 2 for East Asian wide ones,
/// else 1.
int width(char32_t code_point);

/// Columns that `text` takes when it begins at column 0; a tab goes to the next multiple of 4.
int width(std::string_view text);

/// `text` with spaces instead of tabs, and with U+FFFD for everything that a terminal would obey (control
/// characters) and for broken UTF-8. Its width is width(text).
std::string printable(std::string_view text);

}  // namespace pal
