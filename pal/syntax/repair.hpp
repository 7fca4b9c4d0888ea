// The smallest change that mends a mistake. Private to pal/syntax: shows ANTLR.
#pragma once

#include <optional>

#include "pal/syntax/mistake.hpp"
#include "pal/syntax/token_list.hpp"
#include "pal/syntax/tokens.hpp"

namespace pal::syntax {

/// A change near `mistake` after which the parser gets well past it: a missing word or end, a superfluous
/// one, or a misspelled keyword. After Burke and Fisher, "A practical method for LR and LL syntactic error
/// diagnosis and recovery", ACM TOPLAS 9(2), 1987. Nothing if there is none.
std::optional<Change> repair_of(const Mistake& mistake, Tokens& tokens);

/// False if its unit is so long that trying changes would take too long.
bool may_be_mended(const Mistake& mistake);

/// Whether the parser gets past `mistake` and into the next line after `change`.
bool gets_past(const Change& change, const Mistake& mistake, Tokens& tokens);

/// The mistake as `change` mends it: what is missing, too many or misspelled, with the fix if a program can
/// make it.
Diagnostic told_by(const Change& change, const Mistake& mistake, const Tokens& tokens);

}  // namespace pal::syntax
