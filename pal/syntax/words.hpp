// How a word of canonical PAL is spelled, and how it stands in its line. Private to pal/syntax: shows ANTLR.
#pragma once

#include <antlr4-runtime.h>

#include "pal/syntax/lines.hpp"

namespace pal::syntax {

/// A token and the rule of the grammar that it stands in.
struct PlacedToken {
  const antlr4::Token* token = nullptr;
  const antlr4::ParserRuleContext* in = nullptr;
};

/// The word for `here`, which follows `before` in its line (nullptr: begins it). `cell` is not filled in.
Word word_of(const PlacedToken& here, const PlacedToken* before);

/// The table of the line that begins with `first`, and the column that a later word of it may begin.
Table table_of(const PlacedToken& first);
std::size_t cell_of(Table table, std::size_t position, const PlacedToken& here, const PlacedToken& before);

}  // namespace pal::syntax
