#include "pal/syntax/first_mistake.hpp"

#include <utility>

#include "PalParser.h"
#include "pal/support/finding.hpp"
#include "pal/syntax/foreign.hpp"
#include "pal/syntax/spelling.hpp"

namespace pal::syntax {

namespace {

using Parser = grammar::PalParser;

bool is_reserved(std::size_t type) {
  return type >= Parser::WTM && type <= Parser::REQUEST;
}

/// Reserved words that begin, divide or end a statement: where these stand, so does a statement's boundary.
bool is_boundary(std::size_t type) {
  switch (type) {
    case Parser::UNTIL:
    case Parser::BEGIN:
    case Parser::END:
    case Parser::END_CASE:
    case Parser::END_CONCURRENT:
    case Parser::END_WTM:
    case Parser::ELSE:
    case antlr4::Token::EOF:
      return true;
    default:
      return begins_statement(type);
  }
}

/// What a rule repeats, if a wrong word between two repetitions is to be skipped there.
std::optional<std::size_t> repeated_by(std::size_t rule) {
  switch (rule) {
    case Parser::RuleFile:
      return Parser::RuleUnit;
    case Parser::RuleStatements:
      return Parser::RuleStatement;
    case Parser::RuleSkillUnit:
      return Parser::RuleSlot;
    case Parser::RuleEnvironmentUnit:
      return Parser::RuleItem;
    default:
      return std::nullopt;
  }
}

const antlr4::ParserRuleContext* parent(const antlr4::ParserRuleContext* context) {
  return dynamic_cast<const antlr4::ParserRuleContext*>(context->parent);
}

void add(const antlr4::misc::IntervalSet& from, std::set<std::size_t>& types) {
  for (const auto type : from.toList()) {
    if (type > 0) types.insert(static_cast<std::size_t>(type));
  }
}

PartialDiagnostic unexpected(const antlr4::Token& at, const std::string& expected) {
  if (expected.empty()) return {Finding::unexpected, spelling(at)};
  return {Finding::unexpected_with, spelling(at), expected};
}

}  // namespace

antlr4::misc::IntervalSet expected_tokens(antlr4::Parser* parser, const std::exception_ptr& error) {
  try {
    if (error) std::rethrow_exception(error);
  } catch (const antlr4::NoViableAltException& exception) {
    const bool at_once = exception.getStartToken() == exception.getOffendingToken();
    if (at_once || exception.getDeadEndConfigs() == nullptr) return parser->getExpectedTokens();
    antlr4::misc::IntervalSet all;
    for (const auto& config : exception.getDeadEndConfigs()->configs)
      all.addAll(parser->getATN().nextTokens(config->state));
    return all;
  } catch (const antlr4::RecognitionException&) {
  }
  return parser->getExpectedTokens();
}

std::size_t offending(std::exception_ptr error) {
  try {
    std::rethrow_exception(std::move(error));
  } catch (const antlr4::RecognitionException& exception) {
    return exception.getOffendingToken()->getTokenIndex();
  }
}

void FirstMistake::tell(antlr4::Parser* parser, const antlr4::Token* at, const PartialDiagnostic& what) {
  auto foreign = foreign_form(tokens_, at, parser->getContext());
  if (!foreign) foreign = foreign_form(tokens_, parser->getCurrentToken(), parser->getContext());
  foreign_ = foreign.has_value();
  Diagnostics one;
  told_ = foreign ? one.report(foreign->what, tokens_.span(foreign->at)) : one.report(what, tokens_.span(at));
}

bool FirstMistake::tell_missing_end(antlr4::Parser* parser, const antlr4::Token* at) {
  const auto* context = parser->getContext();
  if (!is_boundary(at->getType()) && !tokens_.first_on_line(at)) return false;
  const auto& atn = parser->getATN();
  const auto& expected = atn.nextTokens(atn.states[parser->getState()]);
  struct End {
    std::size_t rule;
    std::size_t type;
    std::string_view what;
    std::string_view end;
  };
  static constexpr End ends[] = {
      {Parser::RuleChoose, Parser::END_CASE, "CASE", "END CASE"},
      {Parser::RuleWait, Parser::END_WTM, "WTM", "END WTM"},
      {Parser::RuleWait, Parser::ELSE, "WTM … WITHIN", "ELSE"},
      {Parser::RuleConcurrent, Parser::END_CONCURRENT, "CONCURRENT", "END CONCURRENT"},
      {Parser::RuleRepeat, Parser::UNTIL, "REPEAT", "UNTIL"},
      {Parser::RuleBlock, Parser::END, "BEGIN", "END"},
      {Parser::RuleModuleUnit, Parser::END, "module", "END"},
      {Parser::RuleSkillUnit, Parser::END, "SKILL", "END SKILL"},
      {Parser::RuleEnvironmentUnit, Parser::END, "ENVIRONMENT", "END ENVIRONMENT"},
  };
  for (const auto& end : ends) {
    if (context->getRuleIndex() != end.rule || !expected.contains(end.type)) continue;
    tell(parser, at, {Finding::missing_end, end.what, end.end, spelling(*at), end.end});
    if (!foreign_) told_->note(tokens_.span(context->start), Remark::begins_here);
    return true;
  }
  return false;
}

void FirstMistake::reportNoViableAlternative(antlr4::Parser* parser, const antlr4::NoViableAltException& e) {
  const auto* at = e.getOffendingToken();
  if (tell_missing_end(parser, at)) return;
  const auto expected = expected_tokens(parser, std::make_exception_ptr(e));
  tell_unexpected(parser, at, spelling(expected));
}

void FirstMistake::reportInputMismatch(antlr4::Parser* parser, const antlr4::InputMismatchException& e) {
  const auto* at = e.getOffendingToken();
  if (tell_missing_end(parser, at)) return;
  tell_unexpected(parser, at, spelling(e.getExpectedTokens()));
}

void FirstMistake::tell_unexpected(antlr4::Parser* parser, const antlr4::Token* at,
                                   const std::string& expected) {
  // What is missing at the end of a line is missing there, not on the next one.
  const auto* before = tokens_.before(at);
  if (before != nullptr && tokens_.first_on_line(at) && !expected.empty() &&
      before->getTokenIndex() >= parser->getContext()->start->getTokenIndex()) {
    tell(parser, before, {Finding::expected_after, expected, spelling(*before)});
  } else if (expected == "a name" && is_reserved(at->getType())) {
    tell(parser, at, {Finding::unexpected_word_of_pal, spelling(*at), expected});
  } else {
    tell(parser, at, unexpected(*at, expected));
  }
}

void FirstMistake::sync(antlr4::Parser* parser) {
  const auto repeated = repeated_by(parser->getContext()->getRuleIndex());
  if (!repeated) return;
  const auto& atn = parser->getATN();
  const auto& begin = atn.nextTokens(atn.ruleToStartState[*repeated]);
  const auto type = parser->getCurrentToken()->getType();
  if (begin.contains(type) || type == antlr4::Token::EOF) return;
  const auto follow = getErrorRecoverySet(parser);
  const auto* context = parser->getContext();
  const auto own = atn.nextTokens(atn.states[parser->getState()], parser->getContext());
  // `( … ):` begins the next arm, but of the statement right around this one only.
  const auto* around = parent(context);
  const bool in_arm = around != nullptr && (around->getRuleIndex() == Parser::RuleArm ||
                                            around->getRuleIndex() == Parser::RuleWaitArm);
  if (type == Parser::LEFT ? in_arm
                           : (follow.contains(type) || own.contains(type)) &&
                                 (is_boundary(type) || tokens_.first_on_line(parser->getCurrentToken()))) {
    return;  // the end of the repetition
  }
  const auto* at = parser->getCurrentToken();
  tell(parser, at,
       is_boundary(type) ? PartialDiagnostic(Finding::ends_nothing, spelling(*at))
                         : unexpected(*at, spelling(begin)));
  stop(parser, at->getTokenIndex());
}

void FirstMistake::recover(antlr4::Parser* parser, std::exception_ptr error) {
  stop(parser, offending(error), error);
}

antlr4::Token* FirstMistake::recoverInline(antlr4::Parser* parser) {
  reportError(parser, antlr4::InputMismatchException(parser));
  stop(parser, parser->getCurrentToken()->getTokenIndex());
}

void FirstMistake::stop(antlr4::Parser* parser, std::size_t at, std::exception_ptr error) {
  Mistake mistake;
  mistake.at = at;
  mistake.finding = *told_;
  mistake.foreign = foreign_;
  add(parser->getExpectedTokens(), mistake.expected);
  add(expected_tokens(parser, error), mistake.expected);
  antlr4::tree::ParseTree* unit = parser->getContext();
  const auto is_file = [](const antlr4::tree::ParseTree* tree) {
    return dynamic_cast<const Parser::FileContext*>(tree) != nullptr;
  };
  mistake.between = is_file(unit);
  // Between two units the mistake may be in the one before.
  if (mistake.between && !unit->children.empty()) unit = unit->children.back();
  while (unit->parent != nullptr && !is_file(unit->parent)) unit = unit->parent;
  const auto* context = dynamic_cast<const antlr4::ParserRuleContext*>(unit);
  if (context != nullptr && context->start != nullptr) mistake.unit_begin = context->start->getTokenIndex();
  file = dynamic_cast<Parser::FileContext*>(mistake.between ? parser->getContext() : unit->parent);
  if (file != nullptr && !mistake.between) file->children.pop_back();
  found = std::move(mistake);
  throw antlr4::ParseCancellationException();
}

}  // namespace pal::syntax
