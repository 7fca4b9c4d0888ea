#include "pal/syntax/parse.hpp"

#include <memory>

#include "PalParser.h"
#include "pal/syntax/build.hpp"
#include "pal/syntax/recovery.hpp"
#include "pal/syntax/tokens.hpp"

namespace pal::syntax {

namespace {

using Parser = grammar::PalParser;
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

Tree parse(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  const auto errors_before = diagnostics.errors();
  Tokens tokens(file, sources.text(file), diagnostics);
  Tree nothing;
  nothing.file = file;
  nothing.complete = false;
  if (!tokens.parseable()) return nothing;

  Parser parser(&tokens.stream());
  parser.removeErrorListeners();  // the strategies report for themselves
  auto* root = tokens.has_errors() ? nullptr : parse_quickly(parser);
  if (root == nullptr) root = parse_carefully(parser, tokens, diagnostics);
  const bool complete = diagnostics.errors() == errors_before;
  auto tree = Builder(tokens, diagnostics).build(root);
  tree.complete = complete;
  return tree;
}

}  // namespace pal::syntax
