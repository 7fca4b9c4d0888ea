#include "pal/syntax/reading.hpp"

#include <memory>
#include <utility>

#include "pal/syntax/error_recovery.hpp"
#include "pal/syntax/repair.hpp"

namespace pal::syntax {

namespace {

using Parser = Reading::Parser;
using Simulator = antlr4::atn::ParserATNSimulator;

/// The quick way: SLL prediction without error recovery accepts nearly every correct text.
Parser::FileContext* parse_quickly(Parser& parser) {
  parser.getInterpreter<Simulator>()->setPredictionMode(antlr4::atn::PredictionMode::SLL);
  parser.setErrorHandler(std::make_shared<antlr4::BailErrorStrategy>());
  try {
    return parser.file();
  } catch (const antlr4::ParseCancellationException&) {
    return nullptr;
  }
}

// Mending tries many changes at each mistake. A file with more mistakes, or of more tokens, would take too
// long.
constexpr std::size_t most_mended = 4;
constexpr std::size_t most_tokens = 50'000;

/// Reports and mends one mistake after the other, as long as they can be mended. How many there were.
std::size_t mend(Tokens& tokens, Diagnostics& diagnostics) {
  if (tokens.all().size() > most_tokens) return 0;
  for (std::size_t reported = 0;; ++reported) {
    if (reported == most_mended) return reported;
    const auto mistake = first_mistake(tokens);
    if (!mistake) return reported;
    const auto change = repair_of(*mistake, tokens);
    if (!change) return reported;
    auto told = told_by(*change, *mistake, tokens);
    auto& finding = diagnostics.report(told.code, told.where, std::move(told.message), std::move(told.hint));
    finding.notes = std::move(told.notes);
    finding.fix = std::move(told.fix);
    tokens.apply(*change);
  }
}

Parser::FileContext* parse_carefully(Parser& parser, const Tokens& tokens, std::size_t reported,
                                     Diagnostics& diagnostics) {
  parser.getInterpreter<Simulator>()->setPredictionMode(antlr4::atn::PredictionMode::LL);
  parser.setErrorHandler(std::make_shared<ErrorRecovery>(tokens, diagnostics, reported));
  return parser.file();
}

}  // namespace

Reading::Reading(FileId file, std::string_view text, Diagnostics& diagnostics)
    : tokens_(file, text, diagnostics) {
  if (!tokens_.parseable()) return;
  const auto errors_before = diagnostics.errors();
  parser_.emplace(&tokens_.stream());
  parser_->removeErrorListeners();  // the strategies report for themselves
  root_ = parse_quickly(*parser_);
  if (root_ == nullptr) {
    const auto reported = mend(tokens_, diagnostics);
    tokens_.stream().seek(0);
    parser_.emplace(&tokens_.stream());
    parser_->removeErrorListeners();
    root_ = parse_carefully(*parser_, tokens_, reported, diagnostics);
  }
  complete_ = !tokens_.has_errors() && diagnostics.errors() == errors_before;
}

}  // namespace pal::syntax
