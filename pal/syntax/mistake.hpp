// The first thing in a text that is not PAL. Private to pal/syntax: shows ANTLR.
#pragma once

#include <antlr4-runtime.h>

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "PalParser.h"
#include "pal/support/diagnostic.hpp"
#include "pal/syntax/tokens.hpp"

namespace pal::syntax {

struct Mistake {
  std::size_t at = 0;              // the token that cannot stand where it does
  std::size_t unit_begin = 0;      // the first token of the unit that it is in
  bool between = false;            // two units
  std::set<std::size_t> expected;  // what could stand there
  Diagnostic finding;              // how the parser tells it
  bool foreign = false;            // … by what PAL has instead: no change tells it better
};

/// Parses up to the first mistake; nothing if there is none.
std::optional<Mistake> first_mistake(Tokens& tokens);

/// How far a parser gets with these tokens: the index of the first token that cannot stand where it does, or
/// the number of all tokens.
std::size_t reach(std::vector<std::unique_ptr<antlr4::Token>> tokens, antlr4::TokenSource& text);

/// What could stand at a place, and how a person is told.
struct GoingOn {
  std::set<std::size_t> types;
  std::string spelling;
};

/// What could stand at token `place`, which fits nowhere. Nothing if a token before it cannot stand where it
/// does.
std::optional<GoingOn> going_on_at(std::size_t place, std::vector<std::unique_ptr<antlr4::Token>> tokens,
                                   antlr4::TokenSource& text);

}  // namespace pal::syntax
