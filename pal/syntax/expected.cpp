// Walks the grammar's transition network along the words before a place, and looks at what may come next.
#include "pal/syntax/expected.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

#include "PalLexer.h"
#include "PalParser.h"
#include "pal/support/diagnostic.hpp"
#include "pal/syntax/token_list.hpp"
#include "pal/syntax/tokens.hpp"

namespace pal::syntax {

namespace {

using Parser = grammar::PalParser;
using antlr4::atn::ATNState;
using antlr4::atn::Transition;

/// The parser's tables, once.
const Parser& tables() {
  static antlr4::ANTLRInputStream input;
  static grammar::PalLexer lexer(&input);
  static antlr4::CommonTokenStream tokens(&lexer);
  static const Parser parser(&tokens);
  return parser;
}

/// A rule on the way to a place, and the token that it began with.
struct Entered {
  std::size_t rule = 0;
  std::size_t begin = 0;
};

class Walker {
 public:
  explicit Walker(const std::vector<std::size_t>& types) : atn_(tables().getATN()), types_(types) {}

  /// Collects what may follow if the tokens from `begin` on are the beginning of this rule, or of several.
  void walk_from(std::size_t rule, std::size_t begin) {
    std::set<std::size_t> starts{begin};
    while (!starts.empty()) {  // one after the other
      std::set<std::size_t> next;
      for (const std::size_t start : starts) {
        for (const std::size_t end : walk(rule, start)) {
          if (end > start) next.insert(end);
        }
      }
      starts = std::move(next);
    }
  }

  bool found() const { return !keywords.empty() || !wanted.empty(); }

  std::set<std::string> keywords;
  std::set<Wanted> wanted;

 private:
  /// Where the rule may end.
  const std::set<std::size_t>& walk(std::size_t rule, std::size_t begin) {
    const bool at_place = begin == types_.size();
    const auto key = std::pair(rule, begin);
    if (const auto known = ends_.find(key); known != ends_.end() && !at_place) return known->second;
    path_.push_back({rule, begin});
    std::set<std::size_t> ends;
    std::set<std::pair<ATNState*, std::size_t>> seen;
    std::vector<std::pair<ATNState*, std::size_t>> open{{atn_.ruleToStartState[rule], begin}};
    while (!open.empty()) {
      const auto [state, index] = open.back();
      open.pop_back();
      if (!seen.emplace(state, index).second) continue;
      if (state->getStateType() == ATNState::RULE_STOP) {
        ends.insert(index);
        continue;
      }
      for (const auto* transition : state->transitions) step(*transition, index, open);
    }
    path_.pop_back();
    return ends_[key] = std::move(ends);
  }

  void step(const Transition& transition, std::size_t index,
            std::vector<std::pair<ATNState*, std::size_t>>& open) {
    if (transition.getSerializationType() == Transition::RULE) {
      const auto& rule = dynamic_cast<const antlr4::atn::RuleTransition&>(transition);
      for (const std::size_t end : walk(rule.target->ruleIndex, index))
        open.emplace_back(rule.followState, end);
    } else if (transition.isEpsilon()) {
      open.emplace_back(transition.target, index);
    } else if (index == types_.size()) {
      const antlr4::misc::IntervalSet label = transition.label();
      for (const auto& interval : label.getIntervals()) {
        for (auto type = interval.a; type <= interval.b; ++type) may_come(static_cast<std::size_t>(type));
      }
    } else if (transition.matches(types_[index], 1, Parser::STRAY)) {
      open.emplace_back(transition.target, index + 1);
    }
  }

  std::size_t rule(std::size_t up) const {
    return up < path_.size() ? path_[path_.size() - 1 - up].rule : static_cast<std::size_t>(-1);
  }
  /// The type of the token `before` the place; of the rule `up` its first token.
  std::size_t last() const { return types_.empty() ? 0 : types_.back(); }
  std::size_t first(std::size_t up) const {
    const std::size_t begin = path_[path_.size() - 1 - up].begin;
    return begin < types_.size() ? types_[begin] : 0;
  }

  void may_come(std::size_t type) {
    const std::size_t here = rule(0);
    if (here == Parser::RuleContextual || here == Parser::RuleOpener) return;  // a name, told by NAME
    if (type == Parser::NAME) {
      name();
    } else if (type == Parser::NUMBER) {
      number();
    } else if (type == Parser::STRING) {
      wanted.insert(here == Parser::RuleUses ? Wanted::file : Wanted::text);
    } else if (type == Parser::END_CASE || type == Parser::END_CONCURRENT || type == Parser::END_WTM) {
      keywords.insert(type == Parser::END_CASE         ? "END CASE"
                      : type == Parser::END_CONCURRENT ? "END CONCURRENT"
                                                       : "END WTM");
    } else if (type == Parser::HEADER) {
      for (const char* kind : {"Sensor Driver:", "Logical Sensor:", "Machine Controller:", "Skill Module:",
                               "Contingency Module:"})
        keywords.insert(kind);
    } else if (type == Parser::END && here == Parser::RuleSkillUnit) {
      keywords.insert("END SKILL");
    } else if (type == Parser::END && here == Parser::RuleEnvironmentUnit) {
      keywords.insert("END ENVIRONMENT");
    } else if (here == Parser::RuleUnitFactor) {
      return;
    } else {
      const auto& vocabulary = tables().getVocabulary();
      std::string literal(vocabulary.getLiteralName(type));
      keywords.insert(literal.size() > 2 ? literal.substr(1, literal.size() - 2)
                                         : std::string(vocabulary.getSymbolicName(type)));
    }
  }

  void number() {
    if (rule(0) == Parser::RuleSend || (rule(0) == Parser::RuleMeasure && last() == Parser::COMPLETION)) {
      wanted.insert(Wanted::completion_code);
    } else if (rule(0) == Parser::RuleSlot && first(0) == Parser::COMPLETION &&
               last() == Parser::CONTINGENCY) {
      wanted.insert(Wanted::contingency_number);
    } else {
      wanted.insert(Wanted::number);
    }
  }

  void name() {
    const std::size_t here = rule(0);
    if (here == Parser::RuleDuration || here == Parser::RuleInterval) {
      wanted.insert(Wanted::time_unit);
    } else if (here == Parser::RuleUnitFactor) {
      wanted.insert(Wanted::unit);
    } else if (here == Parser::RuleActivityName) {
      wanted.insert(rule(1) == Parser::RuleHeading ? Wanted::new_name
                    : rule(1) == Parser::RuleItem  ? Wanted::activity_of_time
                                                   : Wanted::activity);
    } else if (here == Parser::RuleName) {
      wanted.insert(name_in(rule(1)));
    }
  }

  Wanted name_in(std::size_t parent) const {
    switch (parent) {
      case Parser::RuleMessage:
      case Parser::RuleAccess:
        return Wanted::message;
      case Parser::RuleConditionUnit:
        return last() == Parser::CONDITION ? Wanted::new_name : Wanted::message;
      case Parser::RuleParty:
        return party_in(rule(2));
      case Parser::RuleSet:
      case Parser::RuleRead:
      case Parser::RuleFactor:
      case Parser::RuleKnown:
        return Wanted::condition;
      case Parser::RuleExecute:
        return Wanted::callee;
      case Parser::RuleNames:
        return listed(first(2), rule(2));
      case Parser::RuleSlot:
        return last() == Parser::METHOD ? Wanted::contingency_method : Wanted::new_name;
      case Parser::RuleMeasure:
        return Wanted::processor;
      case Parser::RuleItem:
        return last() == Parser::ON       ? Wanted::processor
               : last() == Parser::OF     ? Wanted::module
               : last() == Parser::DEVICE ? Wanted::device
                                          : Wanted::new_name;
      case Parser::RuleThreadPart:
        return Wanted::module;
      default:
        return Wanted::new_name;
    }
  }

  Wanted party_in(std::size_t parent) const {
    switch (parent) {
      case Parser::RuleSource:
        return Wanted::sender;
      case Parser::RuleSend:
      case Parser::RulePattern:
        return has_kind_word() ? Wanted::receiver : last() == Parser::FROM ? Wanted::asked : Wanted::receiver;
      case Parser::RuleStep:
        return Wanted::module;
      default:
        return Wanted::party;
    }
  }
  bool has_kind_word() const { return last() != Parser::FROM && last() != Parser::TO; }

  static Wanted listed(std::size_t first, std::size_t parent) {
    switch (first) {
      case Parser::SENSOR:
        return Wanted::sensor_driver;
      case Parser::LOGICAL:
        return Wanted::logical_sensor;
      case Parser::MACHINE:
        return Wanted::machine_controller;
      case Parser::SKILL:
        return Wanted::skill_method;
      case Parser::GENERIC:
        return Wanted::skill;
      default:
        return parent == Parser::RuleHeading ? Wanted::message : Wanted::new_name;
    }
  }

  const antlr4::atn::ATN& atn_;
  const std::vector<std::size_t>& types_;
  std::vector<Entered> path_;
  std::map<std::pair<std::size_t, std::size_t>, std::set<std::size_t>> ends_;
};

bool continues_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

bool begins_unit(std::size_t type) {
  return type == Parser::USES || type == Parser::MESSAGE || type == Parser::CONDITION ||
         type == Parser::DEVICE || type == Parser::HEADER || type == Parser::SKILL ||
         type == Parser::ENVIRONMENT;
}

}  // namespace

Expected expected_at(std::string_view text, std::size_t offset) {
  std::size_t end = std::min(offset, text.size());
  while (end > 0 && continues_word(text[end - 1])) --end;
  const std::size_t line_break = text.substr(0, end).rfind('\n');
  const std::size_t line = line_break == std::string_view::npos ? 0 : line_break + 1;
  Expected result;
  Diagnostics unwanted;
  Tokens tokens(FileId(std::size_t{0}), text.substr(0, end), unwanted);
  std::vector<std::size_t> types;
  std::vector<std::size_t> units;  // tokens that may begin one: those at the beginning of a line
  std::size_t first_on_line = 0;   // of the place's line
  bool line_has_words = false;
  for (const auto* token : tokens.all()) {
    if (token->getType() == antlr4::Token::EOF) break;
    const bool first = tokens.first_on_line(token);
    if (first && token->getCharPositionInLine() == 0 && begins_unit(token->getType()))
      units.push_back(types.size());
    if (!line_has_words && tokens.span(token).begin >= line) {
      line_has_words = true;
      first_on_line = types.size();
      result.line_begins_with = token->getText();
      for (char& c : result.line_begins_with)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    types.push_back(token->getType());
  }
  if (!line_has_words) first_on_line = types.size();
  Walker walker(types);
  walker.walk_from(Parser::RuleUnit, units.empty() ? 0 : units.back());
  if (!walker.found() && !units.empty()) {  // a mistake further up: the line by itself
    const std::size_t unit = types[units.back()];
    if (unit == Parser::SKILL) {
      walker.walk_from(Parser::RuleSlot, first_on_line);
    } else if (unit == Parser::ENVIRONMENT) {
      walker.walk_from(Parser::RuleItem, first_on_line);
    } else {
      walker.walk_from(Parser::RuleStatement, first_on_line);
      walker.walk_from(Parser::RuleArm, first_on_line);
    }
  }
  result.keywords.assign(walker.keywords.begin(), walker.keywords.end());
  result.wanted.assign(walker.wanted.begin(), walker.wanted.end());
  return result;
}

}  // namespace pal::syntax
