#include "pal/syntax/words.hpp"

#include <cctype>
#include <string>

#include "PalParser.h"

namespace pal::syntax {

namespace {

using Parser = grammar::PalParser;

bool is_keyword(const PlacedToken& here) {
  const auto type = here.token->getType();
  if (type != Parser::HEADER && type >= Parser::LEFT) return false;
  const auto rule = here.in->getRuleIndex();
  return rule != Parser::RuleContextual && rule != Parser::RuleOpener && rule != Parser::RuleUnitFactor;
}

std::string in_case(std::string text, bool first_capital, bool rest_capital) {
  bool capital = first_capital;
  for (auto& c : text) {
    const auto letter = static_cast<unsigned char>(c);
    c = static_cast<char>(capital ? std::toupper(letter) : std::tolower(letter));
    capital = rest_capital;
  }
  return text;
}

/// Keywords are capitals, but for those that the thesis prints in another way.
std::string spelled(const PlacedToken& here) {
  auto text = here.token->getText();
  if (!is_keyword(here)) return text;
  const auto type = here.token->getType();
  const auto capitals = [&] { return in_case(std::move(text), true, true); };
  const auto small = [&] { return in_case(std::move(text), false, false); };
  const auto title = [&] { return in_case(std::move(text), true, false); };
  switch (here.in->getRuleIndex()) {
    case Parser::RuleHeader:
    case Parser::RuleExecute:
    case Parser::RuleNothing:
      return title();
    case Parser::RuleKind:
    case Parser::RuleMessage:
    case Parser::RuleSource:
      return small();
    case Parser::RuleEnding:
      return type == Parser::FOREVER ? small() : capitals();
    case Parser::RuleWait:
      return type == Parser::COORDINATOR ? title() : capitals();
    case Parser::RuleSend:
    case Parser::RulePattern:
      if (type == Parser::FROM || type == Parser::TO) return small();
      if (type == Parser::COMPLETION || type == Parser::PROTOCOL) return title();
      return capitals();
    default:
      return capitals();
  }
}

bool joined_to_both_sides(std::size_t type) {
  return type == Parser::DOT || type == Parser::STAR || type == Parser::SLASH || type == Parser::CARET;
}

bool space_between(const PlacedToken& before, const PlacedToken& here) {
  const auto left = before.token->getType();
  const auto right = here.token->getType();
  if (joined_to_both_sides(left) || joined_to_both_sides(right)) return false;
  if (right == Parser::COMMA || right == Parser::SEMICOLON) return false;
  if (right == Parser::LEFT_BRACKET || right == Parser::RIGHT_BRACKET || left == Parser::LEFT_BRACKET)
    return false;
  if (right == Parser::COLON) {
    const auto rule = here.in->getRuleIndex();
    return rule != Parser::RuleModuleUnit && rule != Parser::RuleArm && rule != Parser::RuleWaitArm;
  }
  if (right != Parser::LEFT) return true;
  const bool of_statement = left == Parser::WTM || left == Parser::TXM || left == Parser::SPC ||
                            left == Parser::RPC || left == Parser::UNTIL;
  return !of_statement || !is_keyword(before);
}

/// Where a clause begins, or an item of a list.
bool may_begin_line(const PlacedToken& before, const PlacedToken& here) {
  const auto left = before.token->getType();
  if (left == Parser::COMMA || left == Parser::SEMICOLON) return true;
  const auto rule = here.in->getRuleIndex();
  const auto type = here.token->getType();
  if (type == Parser::STRING) return rule != Parser::RuleLiteral;
  if (!is_keyword(here)) return false;
  switch (type) {
    case Parser::READS:
    case Parser::WRITES:
    case Parser::TIME:
    case Parser::DEFAULT:
    case Parser::RANGE:
    case Parser::METHOD:
    case Parser::AND:
    case Parser::OR:
    case Parser::EVERY:
    case Parser::SPORADIC:
    case Parser::JITTER:
    case Parser::PHASE:
    case Parser::ANSWER:
    case Parser::COLLECTING:
    case Parser::PRIORITY:
    case Parser::AT:
    case Parser::IN:
    case Parser::AFTER:
    case Parser::DURING:
      return true;
    case Parser::FROM:
    case Parser::TO:
      return rule == Parser::RuleMeasure || rule == Parser::RuleConditionUnit;
    case Parser::WITHIN:
      return rule == Parser::RuleWait;
    default:
      return false;
  }
}

}  // namespace

Word word_of(const PlacedToken& here, const PlacedToken* before) {
  Word word;
  word.text = spelled(here);
  if (before == nullptr) return word;
  word.space_before = space_between(*before, here);
  word.may_begin_line = may_begin_line(*before, here);
  return word;
}

Table table_of(const PlacedToken& first) {
  const auto type = first.token->getType();
  if (!is_keyword(first)) return Table::none;
  switch (first.in->getRuleIndex()) {
    case Parser::RuleMessageUnit:
      return Table::message;
    case Parser::RuleConditionUnit:
      return Table::condition;
    case Parser::RuleDeviceUnit:
      return Table::device;
    case Parser::RuleHeading:
      return type == Parser::ACTIVITY ? Table::activity : Table::slot;
    case Parser::RuleSlot:
      return type == Parser::PARAMETER     ? Table::parameter
             : type == Parser::COMPLETION  ? Table::completion
             : type == Parser::REQUIREMENT ? Table::requirement
             : type == Parser::CONTINGENCY ? Table::none
                                           : Table::slot;
    case Parser::RuleItem:
      return type == Parser::PROCESSOR ? Table::processor
             : type == Parser::DEVICE  ? Table::behaviour
             : type == Parser::PLACE   ? Table::placement
             : type == Parser::TIME    ? Table::time
             : type == Parser::COST    ? Table::cost
             : type == Parser::LATENCY ? Table::latency
                                       : Table::slot;
    default:
      return Table::none;
  }
}

std::size_t cell_of(Table table, std::size_t position, const PlacedToken& here, const PlacedToken& before) {
  const auto type = here.token->getType();
  const bool keyword = is_keyword(here);
  const auto is = [&](std::size_t wanted) { return type == wanted && (keyword || type >= Parser::LEFT); };
  switch (table) {
    case Table::message:
    case Table::requirement:
      return is(Parser::COLON) && position == 2 ? 1 : 0;
    case Table::condition:
      return is(Parser::FROM) ? 1 : is(Parser::STRING) ? 2 : 0;
    case Table::device:
    case Table::completion:
      return is(Parser::STRING) ? 1 : 0;
    case Table::activity:
      return is(Parser::READS) ? 1 : is(Parser::WRITES) ? 2 : is(Parser::TIME) ? 3 : 0;
    case Table::slot:
      // The first word after the slot's name.
      return is_keyword(before) && (!keyword || is(Parser::NONE) || is(Parser::STRING)) ? 1 : 0;
    case Table::parameter:
      return is(Parser::COLON)     ? 1
             : is(Parser::DEFAULT) ? 2
             : is(Parser::RANGE)   ? 3
             : is(Parser::STRING)  ? (here.in->getRuleIndex() == Parser::RuleLiteral ? 0 : 4)
                                   : 0;
    case Table::processor:
    case Table::behaviour:
      return position == 2 ? 1 : 0;
    case Table::placement:
      return is(Parser::ON) ? 1 : is(Parser::PRIORITY) ? 2 : 0;
    case Table::time:
      return is(Parser::OF) ? 1 : is(Parser::COLON) ? 2 : 0;
    case Table::cost:
      return position == 2 ? 1 : 0;
    case Table::latency:
      return position == 3 ? 1 : 0;
    case Table::none:
      return 0;
  }
  return 0;
}

}  // namespace pal::syntax
