#include "pal/syntax/error_recovery.hpp"

#include <optional>
#include <string>

#include "PalParser.h"
#include "pal/support/diagnostic_code.hpp"
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
    case Parser::WTM:
    case Parser::TXM:
    case Parser::SPC:
    case Parser::RPC:
    case Parser::CASE:
    case Parser::REPEAT:
    case Parser::UNTIL:
    case Parser::CONCURRENT:
    case Parser::BEGIN:
    case Parser::END:
    case Parser::END_CASE:
    case Parser::END_CONCURRENT:
    case Parser::END_WTM:
    case Parser::EXECUTE:
    case Parser::DO:
    case Parser::ELSE:
    case antlr4::Token::EOF:
      return true;
    default:
      return false;
  }
}

/// Rules in which the parser goes on after a mistake; in all others the mistake is the caller's.
bool recovers(std::size_t rule) {
  switch (rule) {
    case Parser::RuleFile:
    case Parser::RuleUnit:
    case Parser::RuleModuleUnit:
    case Parser::RuleHeading:
    case Parser::RuleStatements:
    case Parser::RuleStatement:
    case Parser::RuleWait:
    case Parser::RuleWaitArm:
    case Parser::RuleChoose:
    case Parser::RuleArm:
    case Parser::RuleRepeat:
    case Parser::RuleConcurrent:
    case Parser::RuleBlock:
    case Parser::RuleSkillUnit:
    case Parser::RuleSlot:
    case Parser::RuleEnvironmentUnit:
    case Parser::RuleItem:
    case Parser::RuleGuard:
    case Parser::RuleEnding:
    case Parser::RuleSource:
      return true;
    default:
      return false;
  }
}

/// Rules after whose mistakes the next of their kind is read afresh: what it says is not hidden by the
/// mistake before.
std::optional<std::size_t> one_of_many(std::size_t rule) {
  switch (rule) {
    case Parser::RuleStatement:
    case Parser::RuleWait:
    case Parser::RuleChoose:
    case Parser::RuleRepeat:
    case Parser::RuleConcurrent:
      return Parser::RuleStatement;
    case Parser::RuleUnit:
    case Parser::RuleSlot:
    case Parser::RuleItem:
      return rule;
    default:
      return std::nullopt;
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

}  // namespace

void report_too_many(Diagnostics& diagnostics, SourceSpan where) {
  diagnostics.report(Code::PAL0104, where, "too many syntax errors; the rest of this file is not reported",
                     "correct the first of them, and make sure that this file is PAL");
}

Diagnostic* ErrorRecovery::report(antlr4::Parser* parser, const antlr4::Token* at, std::string message,
                                  std::string hint) {
  beginErrorCondition(parser);
  ++reported_;
  if (reported_ > most_reports + 1) return nullptr;
  if (reported_ == most_reports + 1) {
    report_too_many(diagnostics_, tokens_.span(at));
    return nullptr;
  }
  auto foreign = foreign_form(tokens_, at, parser->getContext());
  if (!foreign) foreign = foreign_form(tokens_, parser->getCurrentToken(), parser->getContext());
  foreign_ = foreign.has_value();
  if (foreign)
    return &diagnostics_.report(Code::PAL0101, tokens_.span(foreign->at), foreign->message, foreign->hint);
  return &diagnostics_.report(Code::PAL0101, tokens_.span(at), std::move(message), std::move(hint));
}

bool ErrorRecovery::report_missing_end(antlr4::Parser* parser, const antlr4::Token* at) {
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
    auto* finding = report(
        parser, at,
        "this " + std::string(end.what) + " has no " + std::string(end.end) + " before " + spelling(*at),
        "add " + std::string(end.end));
    if (finding != nullptr && !foreign_)
      finding->notes.push_back({tokens_.span(context->start), "it begins here"});
    return true;
  }
  return false;
}

void ErrorRecovery::reportNoViableAlternative(antlr4::Parser* parser, const antlr4::NoViableAltException& e) {
  const auto* at = e.getOffendingToken();
  if (report_missing_end(parser, at)) return;
  antlr4::misc::IntervalSet expected;
  if (const auto* configs = e.getDeadEndConfigs()) {
    for (const auto& config : configs->configs) expected.addAll(parser->getATN().nextTokens(config->state));
  } else {
    expected = getExpectedTokens(parser);
  }
  report_unexpected(parser, at, spelling(expected));
}

void ErrorRecovery::reportInputMismatch(antlr4::Parser* parser, const antlr4::InputMismatchException& e) {
  const auto* at = e.getOffendingToken();
  if (report_missing_end(parser, at)) return;
  report_unexpected(parser, at, spelling(e.getExpectedTokens()));
}

void ErrorRecovery::reportUnwantedToken(antlr4::Parser* parser) {
  if (inErrorRecoveryMode(parser)) return;
  const auto* at = parser->getCurrentToken();
  report_unexpected(parser, at, spelling(getExpectedTokens(parser)));
}

void ErrorRecovery::report_unexpected(antlr4::Parser* parser, const antlr4::Token* at,
                                      const std::string& expected) {
  // What is missing at the end of a line is missing there, not on the next one.
  const auto* before = tokens_.before(at);
  if (before != nullptr && tokens_.first_on_line(at) && !expected.empty() &&
      before->getTokenIndex() >= parser->getContext()->start->getTokenIndex()) {
    report(parser, before, "expected " + expected + " after " + spelling(*before),
           "write " + expected + " here");
  } else {
    report(parser, at, "unexpected " + spelling(*at) + (expected.empty() ? "" : ", expected " + expected),
           expected.empty() ? "remove it, or correct what stands before it"
           : expected == "a name" && is_reserved(at->getType())
               ? "write another name: " + spelling(*at) + " is a word of PAL"
               : "write " + expected + " here");
  }
}

void ErrorRecovery::reportMissingToken(antlr4::Parser* parser) {
  if (inErrorRecoveryMode(parser)) return;
  const auto* at = parser->getCurrentToken();
  if (report_missing_end(parser, at)) return;
  const auto words = spelling(getExpectedTokens(parser));
  const auto* before = tokens_.before(at);
  if (before != nullptr && tokens_.first_on_line(at)) {
    report(parser, before, "expected " + words + " after " + spelling(*before), "write " + words + " here");
  } else {
    report(parser, at, "expected " + words + " before " + spelling(*at), "write " + words + " here");
  }
}

antlr4::Token* ErrorRecovery::singleTokenDeletion(antlr4::Parser* parser) {
  // A reserved word is rarely too many: rather it belongs to the next statement.
  if (is_reserved(parser->getCurrentToken()->getType())) return nullptr;
  return DefaultErrorStrategy::singleTokenDeletion(parser);
}

bool ErrorRecovery::goes_on_at(antlr4::Parser* parser, const antlr4::misc::IntervalSet& follow) {
  const auto* token = parser->getCurrentToken();
  const auto type = token->getType();
  if (type == antlr4::Token::EOF) return true;
  if (!follow.contains(type)) return false;
  return is_boundary(type) || tokens_.first_on_line(token);
}

void ErrorRecovery::recover(antlr4::Parser* parser, std::exception_ptr error) {
  if (!recovers(parser->getContext()->getRuleIndex())) std::rethrow_exception(error);
  const auto here = static_cast<int>(parser->getInputStream()->index());
  const auto state = static_cast<ssize_t>(parser->getState());
  // The same place again, in the same state: nothing would ever be consumed.
  if (lastErrorIndex == here && lastErrorStates.contains(state)) parser->consume();
  lastErrorIndex = static_cast<int>(parser->getInputStream()->index());
  lastErrorStates.add(state);
  const auto rule = parser->getContext()->getRuleIndex();
  if (rule == Parser::RuleGuard || rule == Parser::RuleEnding) return skip_in_parentheses(parser, false);
  if (rule == Parser::RuleSource) return skip_in_parentheses(parser, true);
  const auto follow = getErrorRecoverySet(parser);
  while (!goes_on_at(parser, follow)) parser->consume();
  // Without a step forward, forgetting the mistake would be to make it again, for ever.
  if (parser->getCurrentToken()->getTokenIndex() <= parser->getContext()->start->getTokenIndex()) return;
  const auto next = one_of_many(rule);
  const auto& atn = parser->getATN();
  if (next && atn.nextTokens(atn.ruleToStartState[*next]).contains(parser->getCurrentToken()->getType())) {
    endErrorCondition(parser);
  }
}

void ErrorRecovery::skip_in_parentheses(antlr4::Parser* parser, bool with_the_last) {
  while (true) {
    const auto* token = parser->getCurrentToken();
    const auto type = token->getType();
    if (type == Parser::RIGHT) {
      if (with_the_last) parser->consume();
      return;
    }
    if (is_boundary(type) || tokens_.first_on_line(token)) return;
    parser->consume();
  }
}

void ErrorRecovery::sync(antlr4::Parser* parser) {
  const auto repeated = repeated_by(parser->getContext()->getRuleIndex());
  if (!repeated) return;
  const auto& atn = parser->getATN();
  const auto& begin = atn.nextTokens(atn.ruleToStartState[*repeated]);
  const auto type = parser->getCurrentToken()->getType();
  if (begin.contains(type) || type == antlr4::Token::EOF) return;
  auto follow = getErrorRecoverySet(parser);
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
  if (!inErrorRecoveryMode(parser)) {
    const auto* at = parser->getCurrentToken();
    const bool is_end = is_boundary(type);
    const auto words = is_end ? std::string() : spelling(begin);
    report(parser, at,
           is_end ? spelling(*at) + " ends nothing that is open here"
                  : "unexpected " + spelling(*at) + (words.empty() ? "" : ", expected " + words),
           is_end          ? "remove it, or add what it is to end"
           : words.empty() ? "remove it, or correct what stands before it"
                           : "write " + words + " here");
  }
  follow.addAll(begin);
  follow.addAll(own);
  parser->consume();
  while (!goes_on_at(parser, follow)) parser->consume();
}

}  // namespace pal::syntax
