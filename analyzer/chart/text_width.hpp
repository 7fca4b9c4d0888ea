// How wide text will be, so that labels can be placed without a font at hand.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pal::analyzer::chart {

/// A length on the page; ten to a CSS pixel, so that no coordinate needs a decimal.
using Length = std::int64_t;

/// Upper estimate of the width of UTF-8 text at this font size: the advance widths of DejaVu Sans, the widest
/// of the usual sans-serif fonts.
Length text_width(std::string_view text, Length font_size, bool bold = false);

/// The text, or its beginning with an ellipsis, so that it is at most `width` wide; empty if not even that
/// fits.
std::string fitted(std::string_view text, Length font_size, Length width, bool bold = false);

/// The text in lines of at most that width, broken at spaces; a word that is wider stands alone, and is cut.
std::vector<std::string> wrapped(std::string_view text, Length font_size, Length width, bool bold = false);

}  // namespace pal::analyzer::chart
