// Characters that do not belong to PAL, reported by what they are. Private to pal/syntax: shows ANTLR.
#pragma once

#include <antlr4-runtime.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "pal/support/diagnostic.hpp"

namespace pal::syntax {

class Tokens;

/// Tokens [first, last] are read as one token of this type and text; type 0: they are left out. A word may be
/// read before that token.
struct Rereading {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t type = 0;
  std::string text;
  std::size_t before = 0;  // its type; 0: there is none
  std::string before_text{};
};

struct Strays {
  bool parseable = true;  // false: the file is something else than PAL, or nearly all of it is
  bool has_errors = false;
  std::vector<Rereading> rereadings;  // in the order of the text
};

/// Reports each character, or run of characters, that has no meaning in PAL. Examples are typographic quotes,
/// letters that names may not have, comments of other languages, and a text without a closing quote. Returns
/// how to read on, so that nothing else is reported for the same mistake.
Strays read_strays(const Tokens& tokens, std::string_view text, Diagnostics& diagnostics);

}  // namespace pal::syntax
