// What the parser does after a mistake. Private to pal/syntax: shows ANTLR.
#pragma once

#include <antlr4-runtime.h>

#include <cstddef>
#include <string>

#include "pal/support/diagnostic.hpp"
#include "pal/syntax/tokens.hpp"

namespace pal::syntax {

// A file that is not PAL at all needs no more than this to see it.
constexpr std::size_t most_reports = 20;

/// Reports that no more mistakes of this file are reported.
void report_too_many(Diagnostics& diagnostics, SourceSpan where);

/// Reports each mistake once, and goes on at the next statement, slot or unit:
/// - If the rest then fits, a word that is in the way is dropped, or a missing one is made up.
/// - Otherwise the statement is given up. Reading goes on at the next line where it can. A reserved word that
///   belongs to a statement around this one is left to that one. So a forgotten END CASE costs one statement.
class ErrorRecovery : public antlr4::DefaultErrorStrategy {
 public:
  /// `reported`: how many mistakes of this file were reported before; after `most_reports` no more are.
  ErrorRecovery(const Tokens& tokens, Diagnostics& diagnostics, std::size_t reported = 0)
      : tokens_(tokens), diagnostics_(diagnostics), reported_(reported) {}

  void recover(antlr4::Parser* parser, std::exception_ptr error) override;
  void sync(antlr4::Parser* parser) override;

 protected:
  /// The last report was about a form of other languages (foreign_form).
  bool foreign() const { return foreign_; }
  void reportNoViableAlternative(antlr4::Parser* parser, const antlr4::NoViableAltException& e) override;
  void reportInputMismatch(antlr4::Parser* parser, const antlr4::InputMismatchException& e) override;
  void reportUnwantedToken(antlr4::Parser* parser) override;
  void reportMissingToken(antlr4::Parser* parser) override;
  antlr4::Token* singleTokenDeletion(antlr4::Parser* parser) override;

 private:
  /// Returns nothing, and reports nothing, for a mistake that was reported before.
  virtual Diagnostic* report(antlr4::Parser* parser, const antlr4::Token* at, std::string message,
                             std::string hint = {});
  /// Reports that the required word is missing, if the next word is another one.
  void report_unexpected(antlr4::Parser* parser, const antlr4::Token* at, const std::string& expected);
  /// If a compound statement or a unit lacks its end here: reports it and returns true.
  bool report_missing_end(antlr4::Parser* parser, const antlr4::Token* at);
  bool goes_on_at(antlr4::Parser* parser, const antlr4::misc::IntervalSet& follow);
  void skip_in_parentheses(antlr4::Parser* parser, bool with_the_last);

  const Tokens& tokens_;
  Diagnostics& diagnostics_;
  std::size_t reported_ = 0;
  bool foreign_ = false;
};

}  // namespace pal::syntax
