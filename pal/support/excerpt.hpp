// Lines of a text as a terminal shows them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pal {

/// The shown part of a line, and the place in it in columns.
struct Excerpt {
  std::string text;
  int caret_column = 0;
  int caret_width = 1;
};

/// `line` with bytes [begin, end) in view. Of a long line only the part around them is shown, cut at code
/// points, with "..." for what is left out.
Excerpt excerpt(std::string_view line, std::size_t begin, std::size_t end);

}  // namespace pal
