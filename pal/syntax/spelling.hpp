// Tokens as messages name them. Private to pal/syntax: shows ANTLR.
#pragma once

#include <antlr4-runtime.h>

#include <string>

namespace pal::syntax {

/// "'END CASE'", "name 'foo'", "the end of the file", …
std::string spelling(const antlr4::Token& token);

/// What stands in `expected`, in words: "a statement, 'END' or 'UNTIL'"; empty if that would be too long to
/// help.
std::string spelling(const antlr4::misc::IntervalSet& expected);

/// One kind of token: "'UNTIL'", "a name", "a number".
std::string spelling_of_type(std::size_t type);

}  // namespace pal::syntax
