// The parser's strategy up to the first mistake: tells it, and stops. Private to pal/syntax: shows ANTLR.
#pragma once

#include <antlr4-runtime.h>

#include <cstddef>
#include <exception>
#include <optional>
#include <string>

#include "PalParser.h"
#include "pal/support/diagnostic.hpp"
#include "pal/syntax/mistake.hpp"
#include "pal/syntax/tokens.hpp"

namespace pal::syntax {

/// The token that `error` says cannot stand where it does.
std::size_t offending(std::exception_ptr error);

/// What could stand where the parser cannot go on. Where a decision failed, what would have gone on there.
antlr4::misc::IntervalSet expected_tokens(antlr4::Parser* parser, const std::exception_ptr& error);

/// Throws ParseCancellationException at the first mistake.
class FirstMistake : public antlr4::DefaultErrorStrategy {
 public:
  explicit FirstMistake(const Tokens& tokens) : tokens_(tokens) {}

  void recover(antlr4::Parser* parser, std::exception_ptr error) override;
  antlr4::Token* recoverInline(antlr4::Parser* parser) override;
  void sync(antlr4::Parser* parser) override;

  std::optional<Mistake> found;
  /// The units before that with the mistake. The parser owns them.
  grammar::PalParser::FileContext* file = nullptr;

 protected:
  void reportNoViableAlternative(antlr4::Parser* parser, const antlr4::NoViableAltException& e) override;
  void reportInputMismatch(antlr4::Parser* parser, const antlr4::InputMismatchException& e) override;

 private:
  /// How the mistake is told, by the form of another language if it is one (foreign_form).
  void tell(antlr4::Parser* parser, const antlr4::Token* at, const PartialDiagnostic& what);
  /// Tells that the required word is missing, if the next word is another one.
  void tell_unexpected(antlr4::Parser* parser, const antlr4::Token* at, const std::string& expected);
  /// If a compound statement or a unit lacks its end here: tells it and returns true.
  bool tell_missing_end(antlr4::Parser* parser, const antlr4::Token* at);
  [[noreturn]] void stop(antlr4::Parser* parser, std::size_t at, std::exception_ptr error = nullptr);

  const Tokens& tokens_;
  std::optional<Diagnostic> told_;
  bool foreign_ = false;
};

}  // namespace pal::syntax
