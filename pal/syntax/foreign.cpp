#include "pal/syntax/foreign.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string_view>

#include "PalParser.h"
#include "pal/syntax/spelling.hpp"

namespace pal::syntax {
namespace {

using Parser = grammar::PalParser;

std::string in_capitals(const antlr4::Token* token) {
  std::string text = token->getText();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return text;
}

bool is(const antlr4::Token* token, std::size_t type) {
  return token != nullptr && token->getType() == type;
}

bool is_if(const antlr4::Token* token) {
  return is(token, Parser::NAME) && in_capitals(token) == "IF";
}

bool is_loop(const antlr4::Token* token) {
  return is(token, Parser::NAME) && (in_capitals(token) == "WHILE" || in_capitals(token) == "FOR");
}

bool touch(const antlr4::Token* left, const antlr4::Token* right) {
  return left->getStopIndex() + 1 == right->getStartIndex();
}

bool is_type_elsewhere(const antlr4::Token* token) {
  static constexpr std::array<std::string_view, 10> types{"FLOAT", "DOUBLE", "INT",    "LONG", "BOOL",
                                                          "CHAR",  "STRING", "NUMBER", "VOID", "EVENT"};
  return std::find(types.begin(), types.end(), in_capitals(token)) != types.end();
}

/// The tokens around one.
class Around {
 public:
  Around(const Tokens& tokens, const antlr4::Token* at) : all_(tokens.all()), at_(at->getTokenIndex()) {}

  /// So many behind it, or before it; null: there is none.
  const antlr4::Token* operator[](std::ptrdiff_t steps) const {
    const auto place = static_cast<std::ptrdiff_t>(at_) + steps;
    const bool inside = place >= 0 && place < static_cast<std::ptrdiff_t>(all_.size());
    return inside ? all_[static_cast<std::size_t>(place)] : nullptr;
  }

 private:
  const std::vector<antlr4::Token*>& all_;
  std::size_t at_;
};

std::optional<Foreign> type_elsewhere(const Around& around) {
  for (const std::ptrdiff_t back : {0, -1}) {
    const auto* type = around[back];
    if (!is(type, Parser::NAME) || !is(around[back - 1], Parser::COLON) || !is_type_elsewhere(type)) continue;
    const std::string word = in_capitals(type);
    const bool is_text = word == "STRING" || word == "CHAR";
    return Foreign{type,
                   {either<Finding::no_such_type_but_text, Finding::no_such_type>(is_text), spelling(*type)}};
  }
  return std::nullopt;
}

/// x[3] : REAL mm, or REAL mm[3].
std::optional<Foreign> size_elsewhere(const Around& around) {
  for (const std::ptrdiff_t step : {0, 1}) {
    const auto* bracket = around[step];
    const auto* number = around[step + 1];
    if (!is(bracket, Parser::LEFT_BRACKET) || !is(number, Parser::NUMBER)) continue;
    if (!is(around[step - 1], Parser::NAME)) return std::nullopt;
    return Foreign{bracket, {Finding::size_behind_type, number->getText()}};
  }
  return std::nullopt;
}

Foreign no_if(const antlr4::Token* at) {
  return {at, {Finding::no_if}};
}

const antlr4::Token* first_of_line(const Around& around) {
  std::ptrdiff_t back = 0;
  while (around[back - 1] != nullptr && around[back - 1]->getLine() == around[0]->getLine()) --back;
  return around[back];
}

/// Told at the word that began the loop, also where its DO is in the way.
Foreign no_loop(const Around& around, std::ptrdiff_t steps) {
  const auto* at = around[steps];
  for (std::ptrdiff_t back = steps; around[back] != nullptr; --back) {
    if (is_loop(around[back]) && !is(around[back - 1], Parser::END)) {
      at = around[back];
      break;
    }
  }
  return {at, {Finding::no_such_loop, in_capitals(at)}};
}

/// Of a comma that cannot stand where it does.
std::optional<Foreign> comma(const Around& around) {
  const auto* before = around[-1];
  const auto* after = around[1];
  if (is(before, Parser::NUMBER) && is(after, Parser::NUMBER) && touch(before, around[0]) &&
      touch(around[0], after)) {
    return Foreign{around[0], {Finding::decimal_point, before->getText(), after->getText()}};
  }
  const bool wait = is(before, Parser::NAME) && is(around[-2], Parser::FROM) &&
                    is(around[-4], Parser::LEFT) && is(around[-5], Parser::WTM);
  if (!wait || !is(after, Parser::NUMBER)) return std::nullopt;
  const auto* unit = around[2];
  const std::string limit = after->getText() + (is(unit, Parser::NAME) ? " " + unit->getText() : "");
  return Foreign{around[0], {Finding::limit_behind_wait, limit}};
}

}  // namespace

std::optional<Foreign> foreign_form(const Tokens& tokens, const antlr4::Token* at,
                                    const antlr4::ParserRuleContext* context) {
  const Around around(tokens, at);
  if (is(around[-1], Parser::COLON) && is(around[-3], Parser::REQUIREMENT))
    return Foreign{at, {Finding::no_such_measure, spelling(*at)}};
  const auto* outer = dynamic_cast<const antlr4::ParserRuleContext*>(context->parent);
  const std::size_t rule = context->getRuleIndex();
  switch (at->getType()) {
    case Parser::ELSE:
      if (outer == nullptr || outer->getRuleIndex() != Parser::RuleArm) return std::nullopt;
      return Foreign{at, {Finding::case_has_no_else}};
    case Parser::COMMA:
      return comma(around);
    case Parser::SLASH:
      if (!is(around[1], Parser::SLASH) || !touch(at, around[1])) return std::nullopt;
      return Foreign{at, {Finding::comment_of_slashes}};
    case Parser::FALSE:
      if (!is(around[-1], Parser::LEFT) || !is(around[-2], Parser::UNTIL)) return std::nullopt;
      return Foreign{at, {Finding::until_of_no_condition}};
    case Parser::DO:
      if (is_loop(first_of_line(around))) return no_loop(around, 0);
      break;
    case Parser::LEFT:
      if (is_if(around[-1])) return no_if(around[-1]);
      if (is_loop(around[-1])) return no_loop(around, -1);
      break;
    case Parser::END:
      if (is_if(around[1])) return no_if(around[1]);
      if (is_loop(around[1])) return no_loop(around, 1);
      break;
    case Parser::NAME:
      if (is_if(at) && is(around[-1], Parser::END)) return no_if(at);
      if (is_loop(at) && is(around[-1], Parser::END)) return no_loop(around, 0);
      break;
    default:
      break;
  }
  const bool payload = rule == Parser::RuleFieldGroup || rule == Parser::RulePayload ||
                       rule == Parser::RuleType || rule == Parser::RuleParameterType ||
                       rule == Parser::RuleMessageUnit;
  // Behind a unit the declaration may be over already: then it is the file that has no use for a bracket.
  const bool declared = payload || rule == Parser::RulePhysicalUnit || rule == Parser::RuleUnitFactor ||
                        rule == Parser::RuleFile;
  if (auto misplaced = declared ? size_elsewhere(around) : std::nullopt) return misplaced;
  return payload ? type_elsewhere(around) : std::nullopt;
}

}  // namespace pal::syntax
