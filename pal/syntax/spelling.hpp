// Tokens as messages name them. Private to pal/syntax: shows ANTLR.
#pragma once

#include <antlr4-runtime.h>

#include <cstddef>
#include <optional>
#include <set>
#include <string>

namespace pal::syntax {

/// "'END CASE'", "name 'foo'", "the end of the file", …
std::string spelling(const antlr4::Token& token);

/// What stands in `expected`, in words: "a statement, 'END' or 'UNTIL'"; empty if that would be too long to
/// help.
std::string spelling(const antlr4::misc::IntervalSet& expected);

/// One kind of token: "'UNTIL'", "a name", "a number".
std::string spelling_of_type(std::size_t type);

/// The same without quotes, as it is written: "UNTIL", "END", "(".
std::string word_of_type(std::size_t type);

/// Whether this kind of token is a keyword that a statement begins with.
bool begins_statement(std::size_t type);

/// The keyword among `types` of which `word` is most likely a misspelling.
std::optional<std::size_t> keyword_like(const std::string& word, const std::set<std::size_t>& types);

}  // namespace pal::syntax
