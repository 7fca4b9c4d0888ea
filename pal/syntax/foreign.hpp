// Forms of other languages, such as IF, where PAL has its own. Private to pal/syntax: shows ANTLR.
#pragma once

#include <antlr4-runtime.h>

#include <optional>

#include "pal/support/finding.hpp"
#include "pal/syntax/tokens.hpp"

namespace pal::syntax {

/// A mistake that is reported by naming PAL's own form. No edit mends it.
struct Foreign {
  const antlr4::Token* at = nullptr;
  PartialDiagnostic what;
};

/// The foreign form at or before `at`, a token that cannot stand where it does in `context`; nothing if it is
/// only wrong.
std::optional<Foreign> foreign_form(const Tokens& tokens, const antlr4::Token* at,
                                    const antlr4::ParserRuleContext* context);

}  // namespace pal::syntax
