#include "pal/syntax/reading.hpp"

#include <memory>

#include "pal/syntax/recovery.hpp"

namespace pal::syntax {

namespace {

using Parser = Reading::Parser;
using Simulator = antlr4::atn::ParserATNSimulator;

/// The quick way: nearly every text that is right is told so with SLL prediction, and without recovery.
Parser::FileContext* parse_quickly(Parser& parser) {
  parser.getInterpreter<Simulator>()->setPredictionMode(antlr4::atn::PredictionMode::SLL);
  parser.setErrorHandler(std::make_shared<antlr4::BailErrorStrategy>());
  try {
    return parser.file();
  } catch (const antlr4::ParseCancellationException&) {
    return nullptr;
  }
}

Parser::FileContext* parse_carefully(Parser& parser, const Tokens& tokens, Diagnostics& diagnostics) {
  parser.reset();
  parser.getInterpreter<Simulator>()->setPredictionMode(antlr4::atn::PredictionMode::LL);
  parser.setErrorHandler(std::make_shared<Recovery>(tokens, diagnostics));
  return parser.file();
}

}  // namespace

Reading::Reading(FileId file, std::string_view text, Diagnostics& diagnostics)
    : tokens_(file, text, diagnostics) {
  if (!tokens_.parseable()) return;
  const auto errors_before = diagnostics.errors();
  parser_.emplace(&tokens_.stream());
  parser_->removeErrorListeners();  // the strategies report for themselves
  if (!tokens_.has_errors()) root_ = parse_quickly(*parser_);
  if (root_ == nullptr) root_ = parse_carefully(*parser_, tokens_, diagnostics);
  complete_ = !tokens_.has_errors() && diagnostics.errors() == errors_before;
}

}  // namespace pal::syntax
