// One file's tokens and ANTLR's tree of them. Private to pal/syntax: shows ANTLR.
#pragma once

#include <optional>
#include <string_view>

#include "PalParser.h"
#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"
#include "pal/syntax/tokens.hpp"

namespace pal::syntax {

/// Reads a text as PAL, reporting all its lexical and syntax errors.
class Reading {
 public:
  using Parser = grammar::PalParser;

  Reading(FileId file, std::string_view text, Diagnostics& diagnostics);

  const Tokens& tokens() const { return tokens_; }
  /// What could be understood; nullptr if the text must not be given to a parser.
  Parser::FileContext* root() const { return root_; }
  /// There were no errors.
  bool complete() const { return complete_; }
  /// A line with a mistake, or the text behind one, was left out, or may have another meaning now.
  bool lost() const { return lost_; }

 private:
  Tokens tokens_;
  std::optional<Parser> parser_;  // owns the tree
  Parser::FileContext* root_ = nullptr;
  bool complete_ = false;
  bool lost_ = false;
};

}  // namespace pal::syntax
