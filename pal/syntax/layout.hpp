// Lines of canonical PAL as text. Private to pal/syntax.
#pragma once

#include <string>
#include <vector>

#include "pal/syntax/lines.hpp"

namespace pal::syntax {

/// The columns within which a line is kept where it can be.
constexpr std::size_t line_width = 120;

/// Two columns a level. The columns of neighbours in a table are aligned, and so are the comments behind
/// neighbouring lines. A line that is too long goes on, four columns further in, with the last clause or item
/// that does not fit.
std::string lay_out(const std::vector<Line>& lines);

}  // namespace pal::syntax
