#include "pal/syntax/mistake.hpp"

#include <memory>
#include <utility>

#include "pal/syntax/first_mistake.hpp"
#include "pal/syntax/spelling.hpp"

namespace pal::syntax {
namespace {

using Parser = grammar::PalParser;
using Simulator = antlr4::atn::ParserATNSimulator;

/// Notes how far the parser came, and stops.
class Furthest : public antlr4::DefaultErrorStrategy {
 public:
  void reportError(antlr4::Parser*, const antlr4::RecognitionException&) override {}
  void recover(antlr4::Parser*, std::exception_ptr error) override { stop(offending(error)); }
  antlr4::Token* recoverInline(antlr4::Parser* parser) override {
    stop(parser->getCurrentToken()->getTokenIndex());
  }
  void sync(antlr4::Parser*) override {}

  std::size_t at = 0;

 private:
  [[noreturn]] void stop(std::size_t token) {
    at = token;
    throw antlr4::ParseCancellationException();
  }
};

/// Notes what could stand where the parser stops.
class Expecting : public Furthest {
 public:
  void recover(antlr4::Parser* parser, std::exception_ptr error) override {
    note(parser, error);
    Furthest::recover(parser, error);
  }
  antlr4::Token* recoverInline(antlr4::Parser* parser) override {
    note(parser, nullptr);
    return Furthest::recoverInline(parser);
  }

  GoingOn expected;

 private:
  void note(antlr4::Parser* parser, const std::exception_ptr& error) {
    const auto all = expected_tokens(parser, error);
    expected.spelling = spelling(all);
    for (const auto type : all.toList()) {
      if (type > 0) expected.types.insert(static_cast<std::size_t>(type));
    }
  }
};

}  // namespace

std::optional<Mistake> first_mistake(Tokens& tokens) {
  tokens.stream().seek(0);
  Parser parser(&tokens.stream());
  parser.removeErrorListeners();
  parser.getInterpreter<Simulator>()->setPredictionMode(antlr4::atn::PredictionMode::LL);
  const auto strategy = std::make_shared<FirstMistake>(tokens);
  parser.setErrorHandler(strategy);
  try {
    parser.file();
  } catch (const antlr4::ParseCancellationException&) {
  }
  return std::move(strategy->found);
}

std::optional<GoingOn> going_on_at(std::size_t place, std::vector<std::unique_ptr<antlr4::Token>> tokens,
                                   antlr4::TokenSource& text) {
  TokenList list(std::move(tokens), text);
  antlr4::CommonTokenStream stream(&list);
  Parser parser(&stream);
  parser.removeErrorListeners();
  parser.setBuildParseTree(false);
  parser.getInterpreter<Simulator>()->setPredictionMode(antlr4::atn::PredictionMode::LL);
  const auto strategy = std::make_shared<Expecting>();
  parser.setErrorHandler(strategy);
  try {
    parser.file();
  } catch (const antlr4::ParseCancellationException&) {
    if (strategy->at == place) return std::move(strategy->expected);
  }
  return std::nullopt;
}

std::size_t reach(std::vector<std::unique_ptr<antlr4::Token>> tokens, antlr4::TokenSource& text) {
  const auto count = tokens.size();
  TokenList list(std::move(tokens), text);
  antlr4::CommonTokenStream stream(&list);
  Parser parser(&stream);
  parser.removeErrorListeners();
  parser.setBuildParseTree(false);
  parser.getInterpreter<Simulator>()->setPredictionMode(antlr4::atn::PredictionMode::SLL);
  const auto strategy = std::make_shared<Furthest>();
  parser.setErrorHandler(strategy);
  try {
    parser.file();
    return count;
  } catch (const antlr4::ParseCancellationException&) {
    return strategy->at;
  }
}

}  // namespace pal::syntax
