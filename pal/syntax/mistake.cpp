#include "pal/syntax/mistake.hpp"

#include <memory>
#include <utility>

namespace pal::syntax {
namespace {

using Parser = grammar::PalParser;
using Simulator = antlr4::atn::ParserATNSimulator;

std::size_t offending(std::exception_ptr error) {
  try {
    std::rethrow_exception(std::move(error));
  } catch (const antlr4::RecognitionException& exception) {
    return exception.getOffendingToken()->getTokenIndex();
  }
}

void add(const antlr4::misc::IntervalSet& from, std::set<std::size_t>& types) {
  for (const auto type : from.toList()) {
    if (type > 0) types.insert(static_cast<std::size_t>(type));
  }
}

/// Tells the first mistake as ErrorRecovery does, and stops.
class FirstMistake : public ErrorRecovery {
 public:
  FirstMistake(const Tokens& tokens, Diagnostics& diagnostics)
      : ErrorRecovery(tokens, diagnostics), sink_(diagnostics) {}

  void recover(antlr4::Parser* parser, std::exception_ptr error) override {
    stop(parser, offending(error), &error);
  }
  antlr4::Token* recoverInline(antlr4::Parser* parser) override {
    reportError(parser, antlr4::InputMismatchException(parser));
    stop(parser, parser->getCurrentToken()->getTokenIndex(), nullptr);
  }
  void sync(antlr4::Parser* parser) override {
    const auto at = parser->getCurrentToken()->getTokenIndex();
    const auto before = sink_.errors();
    ErrorRecovery::sync(parser);
    if (sink_.errors() != before) stop(parser, at, nullptr);
  }

  std::optional<Mistake> found;

 private:
  [[noreturn]] void stop(antlr4::Parser* parser, std::size_t at, std::exception_ptr* error) {
    Mistake mistake{at, 0, {}, sink_.all().front(), foreign()};
    add(parser->getExpectedTokens(), mistake.expected);
    if (error != nullptr) add_dead_ends(parser, *error, mistake.expected);
    const antlr4::tree::ParseTree* unit = parser->getContext();
    const auto is_file = [](const antlr4::tree::ParseTree* tree) {
      return dynamic_cast<const Parser::FileContext*>(tree) != nullptr;
    };
    // Between two units the mistake may be in the one before.
    if (is_file(unit) && !unit->children.empty()) unit = unit->children.back();
    while (unit->parent != nullptr && !is_file(unit->parent)) unit = unit->parent;
    const auto* context = dynamic_cast<const antlr4::ParserRuleContext*>(unit);
    if (context != nullptr && context->start != nullptr) mistake.unit_begin = context->start->getTokenIndex();
    found = std::move(mistake);
    throw antlr4::ParseCancellationException();
  }

  static void add_dead_ends(antlr4::Parser* parser, std::exception_ptr error, std::set<std::size_t>& types) {
    try {
      std::rethrow_exception(std::move(error));
    } catch (const antlr4::NoViableAltException& exception) {
      if (exception.getDeadEndConfigs() == nullptr) return;
      for (const auto& config : exception.getDeadEndConfigs()->configs)
        add(parser->getATN().nextTokens(config->state), types);
    } catch (const antlr4::RecognitionException&) {
    }
  }

  Diagnostics& sink_;
};

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

}  // namespace

std::optional<Mistake> first_mistake(Tokens& tokens) {
  Diagnostics told;
  tokens.stream().seek(0);
  Parser parser(&tokens.stream());
  parser.removeErrorListeners();
  parser.getInterpreter<Simulator>()->setPredictionMode(antlr4::atn::PredictionMode::LL);
  const auto strategy = std::make_shared<FirstMistake>(tokens, told);
  parser.setErrorHandler(strategy);
  try {
    parser.file();
  } catch (const antlr4::ParseCancellationException&) {
  }
  return std::move(strategy->found);
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
