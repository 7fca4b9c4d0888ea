// What other languages write where PAL has a form of its own. Private to pal/syntax: shows ANTLR.
#pragma once

#include <antlr4-runtime.h>

#include <optional>
#include <string>

#include "pal/syntax/tokens.hpp"

namespace pal::syntax {

/// A mistake that is told by what PAL has instead. No edit mends it.
struct Foreign {
  const antlr4::Token* at = nullptr;
  std::string message;
  std::string hint;
};

/// What is foreign at `at`, a token that cannot stand where it does in `context`, or before it; nothing if it
/// is only wrong.
std::optional<Foreign> foreign_form(const Tokens& tokens, const antlr4::Token* at,
                                    const antlr4::ParserRuleContext* context);

}  // namespace pal::syntax
