// A line that ends before what it says does. Private to pal/syntax: shows ANTLR.
#pragma once

#include <optional>

#include "pal/support/diagnostic.hpp"
#include "pal/syntax/mistake.hpp"
#include "pal/syntax/token_list.hpp"
#include "pal/syntax/tokens.hpp"

namespace pal::syntax {

struct UnfinishedLine {
  Change change;       // puts in what is missing at its end
  Diagnostic finding;  // at its last word
};

/// The line before the one with `mistake`, or up to two lines further up, if it is not finished. Once it is,
/// the parser must get into the line after the mistake. So the next line begins something of its own,
/// whatever its first words could mean: most keywords may be names, too. Nothing if there is no such line.
std::optional<UnfinishedLine> unfinished_line(const Mistake& mistake, Tokens& tokens);

}  // namespace pal::syntax
