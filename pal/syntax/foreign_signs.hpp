// Signs that other languages and word processors write for what PAL writes otherwise. Private to pal/syntax:
// shows ANTLR.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "pal/support/finding.hpp"
#include "pal/syntax/strays.hpp"

namespace pal::syntax {

class Tokens;

/// A sign, how to read on, and how PAL writes it. No fix loses a figure, an operator or a part of a word:
/// where it is not plain what was meant, there is a hint and no fix.
struct ForeignSign {
  std::size_t last;  // its last token
  SourceSpan where;
  PartialDiagnostic what;
  std::vector<Rereading> rereadings;  // in the order of the text
  std::vector<Edit> fix;
};

/// The sign that begins at token `at`, if there is one: a dash between two figures, &&, ², µ before a unit, a
/// figure in hexadecimal.
std::optional<ForeignSign> foreign_sign(const Tokens& tokens, std::string_view text, std::size_t at);

}  // namespace pal::syntax
