#include "pal/syntax/repair.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include "pal/support/finding.hpp"
#include "pal/support/nearest.hpp"
#include "pal/syntax/spelling.hpp"

namespace pal::syntax {
namespace {

using Parser = grammar::PalParser;

// How far a parser must get past a mistake for a change to count: all of `sight`. If no change gets so far,
// the one that gets furthest counts, if it gets past `least`.
constexpr std::size_t sight = 30;
constexpr std::size_t least = 5;
// Between changes that all get that far, looking further decides.
constexpr std::size_t far_sight = 200;
// From the unit's beginning to the mistake; trying changes in a longer one would take too long.
constexpr std::size_t longest_unit = 1500;
// Lines of one name before the mistake that may be a misspelled REPEAT, CASE or CONCURRENT.
constexpr std::size_t most_lines = 12;

using Types = std::vector<std::size_t>;

const std::vector<Types>& ends() {
  static const std::vector<Types> all{{Parser::END_CASE, Parser::CASE},
                                      {Parser::END_WTM, Parser::WTM},
                                      {Parser::END_CONCURRENT, Parser::CONCURRENT},
                                      {Parser::UNTIL, Parser::LEFT, Parser::FOREVER, Parser::RIGHT},
                                      {Parser::END, Parser::SKILL},
                                      {Parser::END, Parser::ENVIRONMENT}};
  return all;
}

/// What is put in before the mistake's place even if the grammar would not go on with it at the place itself.
constexpr std::array usual{Parser::LEFT,       Parser::RIGHT,          Parser::COLON,   Parser::EQUAL,
                           Parser::COMMA,      Parser::FROM,           Parser::TO,      Parser::CASE,
                           Parser::REPEAT,     Parser::CONCURRENT,     Parser::BEGIN,   Parser::END,
                           Parser::END_CASE,   Parser::END_CONCURRENT, Parser::END_WTM, Parser::WTM,
                           Parser::TXM,        Parser::EXECUTE,        Parser::DO,      Parser::FIRST,
                           Parser::COMPLETION, Parser::PARAMETER};

bool stands_for_many(std::size_t type) {
  return type == Parser::NAME || type == Parser::NUMBER || type == Parser::STRING;
}

/// A reserved word or a sign. Of a name it is unknown which is meant.
bool is_word(std::size_t type) {
  return !stands_for_many(type) && !spelling_of_type(type).empty();
}

std::set<std::size_t> openers() {
  return {Parser::REPEAT, Parser::CASE, Parser::CONCURRENT, Parser::BEGIN};
}

std::set<std::size_t> all_keywords() {
  std::set<std::size_t> types;
  for (std::size_t type = Parser::WTM; type < Parser::LEFT; ++type) types.insert(type);
  return types;
}

std::vector<Change> candidates(const Mistake& mistake, const Tokens& tokens) {
  std::vector<Change> result;
  const auto at = mistake.at;
  const auto& all = tokens.all();
  const bool last = at + 1 == all.size();
  // A word that is written twice.
  for (const auto where : {at, at - 1}) {
    const bool keyword = where < all.size() && all[where]->getType() < Parser::LEFT;
    if (where == 0 || last || !keyword) continue;
    if (all[where]->getType() == all[where - 1]->getType()) result.push_back({where, 1, {}});
  }
  // A misspelled keyword.
  for (const auto where : {at, at - 1}) {
    if (where >= all.size() || all[where]->getType() != Parser::NAME) continue;
    for (const auto& keywords : {mistake.expected, all_keywords()}) {
      if (const auto meant = keyword_like(all[where]->getText(), keywords))
        result.push_back({where, 1, {*meant}});
    }
  }
  // A word that was cut in two: FOR EVER.
  if (at > 0 && at < all.size() && all[at]->getType() == Parser::NAME &&
      all[at - 1]->getType() == Parser::NAME) {
    if (const auto meant = keyword_like(all[at - 1]->getText() + all[at]->getText(), all_keywords()))
      result.push_back({at - 1, 2, {*meant}});
  }
  // A misspelled keyword that stands for an activity on a line of its own: what it opened is missed at its
  // end.
  std::size_t tried = 0;
  for (auto where = at; where-- > mistake.unit_begin && tried < most_lines;) {
    if (all[where]->getType() != Parser::NAME || !tokens.first_on_line(all[where])) continue;
    if (all[where + 1]->getLine() == all[where]->getLine()) continue;
    ++tried;
    if (const auto meant = keyword_like(all[where]->getText(), openers()))
      result.push_back({where, 1, {*meant}});
  }
  // Between units any name could be made one by a word before it: rather it is too many.
  if (mistake.expected.contains(Parser::USES) && !last) result.push_back({at, 1, {}});
  // A missing name: most words of PAL may be names, and are not what is missing there.
  if (mistake.expected.contains(Parser::NAME) && mistake.expected.contains(Parser::USES))
    result.push_back({at, 0, {Parser::NAME}});
  // A missing end, word or sign.
  for (const Types& end : ends()) {
    if (mistake.expected.contains(end.front())) result.push_back({at, 0, end});
  }
  if (mistake.expected.contains(Parser::TO)) result.push_back({at, 0, {Parser::TO}});
  for (const auto type : mistake.expected) {
    if (is_word(type)) result.push_back({at, 0, {type}});
  }
  // One of the two words of an end; something between them; an end that lies between them, of which each is
  // half.
  if (all[at]->getType() == Parser::END) {
    for (std::size_t i = 0; i < 3; ++i) result.push_back({at, 1, ends()[i]});
    if (!last) result.push_back({at + 1, 1, {}});
  } else if (all[at]->getType() == Parser::END_CASE || all[at]->getType() == Parser::END_WTM ||
             all[at]->getType() == Parser::END_CONCURRENT) {
    for (const Types& end : ends()) result.push_back({at + 1, 0, end});
  }
  if (!last) result.push_back({at, 1, {}});
  for (const auto type : mistake.expected) {
    if (stands_for_many(type)) result.push_back({at, 0, {type}});
  }
  for (const auto type : usual) result.push_back({at, 0, {type}});
  // A word before.
  for (std::size_t back = 1; back <= 3 && back <= at - std::min(at, mistake.unit_begin); ++back) {
    for (const auto type : usual) result.push_back({at - back, 0, {type}});
    result.push_back({at - back, 1, {}});
  }
  // What stands before a parenthesis.
  auto left = at;
  while (left > mistake.unit_begin && at - left < 12 && all[left]->getType() != Parser::LEFT) --left;
  if (all[left]->getType() == Parser::LEFT && at - left > 3) {
    for (const auto type : {Parser::WTM, Parser::TXM, Parser::SPC, Parser::RPC, Parser::CASE, Parser::UNTIL})
      result.push_back({left, 0, {type}});
  }
  return result;
}

/// How many tokens of the text the parser gets past the mistake after `change`, `most` at most.
std::size_t progress(const Change& change, const Mistake& mistake, std::size_t most, Tokens& tokens) {
  const auto end = std::min(tokens.all().size() - 1, mistake.at + most);
  const bool whole = end == tokens.all().size() - 1;
  auto window = copy(tokens.all(), mistake.unit_begin, end, &change);
  const auto count = window.size();
  const auto shift = change.added.size();
  const auto reached = reach(std::move(window), tokens.text());
  if (reached >= count || (!whole && reached + 1 == count)) return most;
  const auto in_text = reached + mistake.unit_begin + change.removed;
  return in_text < mistake.at + shift ? 0 : in_text - shift - mistake.at;
}

/// Whether both put in one word at the same place, each one that is expected there, and not the same. TO is
/// no less certain for FROM: that is behind requests alone.
bool is_other_word(const Change& one, const Change& other, const Mistake& mistake) {
  const auto inserts_expected = [&](const Change& change) {
    return change.removed == 0 && change.added.size() == 1 && mistake.expected.contains(change.added.front());
  };
  return one.at == other.at && inserts_expected(one) && inserts_expected(other) && one.added != other.added &&
         other.added.front() != Parser::TO;
}

}  // namespace

bool may_be_mended(const Mistake& mistake) {
  return mistake.at >= mistake.unit_begin && mistake.at - mistake.unit_begin <= longest_unit;
}

bool gets_past(const Change& change, const Mistake& mistake, Tokens& tokens) {
  const auto& all = tokens.all();
  std::size_t next_line = mistake.at + 1;
  while (next_line + 1 < all.size() && !tokens.first_on_line(all[next_line])) ++next_line;
  return progress(change, mistake, sight, tokens) >= std::min(sight, next_line + 1 - mistake.at);
}

std::optional<Change> repair_of(const Mistake& mistake, Tokens& tokens) {
  if (!may_be_mended(mistake)) return std::nullopt;
  std::vector<Change> best;
  std::size_t furthest = least;
  for (Change& change : candidates(mistake, tokens)) {
    const auto gain = progress(change, mistake, sight, tokens);
    if (gain < furthest) continue;
    if (gain > furthest) best.clear();
    furthest = gain;
    best.push_back(std::move(change));
  }
  if (best.empty()) return std::nullopt;
  std::vector<std::size_t> gains;
  for (const Change& change : best)
    gains.push_back(best.size() == 1 || furthest < sight ? furthest
                                                         : progress(change, mistake, far_sight, tokens));
  const auto greatest = std::max_element(gains.begin(), gains.end());
  Change& chosen = best[static_cast<std::size_t>(greatest - gains.begin())];
  for (std::size_t i = 0; i < best.size(); ++i) {
    if (gains[i] == *greatest && is_other_word(best[i], chosen, mistake)) chosen.one_of_several = true;
  }
  return chosen;
}

namespace {

std::string words_of(const Types& types) {
  std::string text;
  for (const auto type : types) text += (text.empty() ? "" : " ") + word_of_type(type);
  return text;
}

/// What is put in stands after the word before on its line, or on a line of its own if it ends something.
Edit insertion(const Change& change, const Mistake& mistake, const Tokens& tokens) {
  const auto& all = tokens.all();
  const auto* next = all[change.at];
  const auto* before = change.at == 0 ? nullptr : all[change.at - 1];
  const auto words = words_of(change.added);
  auto place = tokens.span(next);
  place.end = place.begin;
  const bool at_end = next->getType() == antlr4::Token::EOF;
  if (before == nullptr || (!tokens.first_on_line(next) && !at_end)) return {place, words + " "};
  place.begin = place.end = tokens.span(before).end;
  const bool ends_something = !mistake.finding.notes.empty();
  if (!ends_something) return {place, " " + words};
  const auto& begin = mistake.finding.notes.front().where;
  const auto* opener = *std::find_if(all.begin(), all.end(), [&](const antlr4::Token* token) {
    return tokens.span(token).begin >= begin.begin;
  });
  return {place, "\n" + std::string(opener->getCharPositionInLine(), ' ') + words};
}

/// Behind a number only a unit of time is missing that is a name to the grammar.
bool is_unit_of_time(const Change& change, const Tokens& tokens) {
  const auto* before = tokens.before(tokens.all()[change.at]);
  return change.added.front() == Parser::NAME && before != nullptr && before->getType() == Parser::NUMBER;
}

/// Words that begin a line of a template or an environment, or a unit of the file.
bool begins_line(std::size_t type) {
  switch (type) {
    case Parser::USES:
    case Parser::MESSAGE:
    case Parser::CONDITION:
    case Parser::DEVICE:
    case Parser::SKILL:
    case Parser::ENVIRONMENT:
    case Parser::PARAMETER:
    case Parser::COMPLETION:
    case Parser::CONTINGENCY:
    case Parser::REQUIREMENT:
    case Parser::PROCESSOR:
    case Parser::PLACE:
    case Parser::COST:
    case Parser::LATENCY:
      return true;
    default:
      return false;
  }
}

/// What may be taken out of a text without changing what it says: a bracket or a divider that does not stand
/// between figures, an end too many, and a word that is written twice.
bool says_nothing(std::size_t at, const Tokens& tokens) {
  const auto& all = tokens.all();
  const auto type = all[at]->getType();
  const bool twice = at > 0 && all[at - 1]->getType() == type && type < Parser::LEFT;
  const bool between_figures = at > 0 && at + 1 < all.size() && all[at - 1]->getType() == Parser::NUMBER &&
                               all[at + 1]->getType() == Parser::NUMBER;
  switch (type) {
    case Parser::COMMA:
    case Parser::COLON:
    case Parser::SEMICOLON:
      return !between_figures;
    case Parser::LEFT:
    case Parser::RIGHT:
    case Parser::END:
    case Parser::END_CASE:
    case Parser::END_CONCURRENT:
    case Parser::END_WTM:
    case Parser::BEGIN:
      return true;
    default:
      return twice;
  }
}

/// Whether a program may make the change: no figure, operator or name is lost, and no line begins within one.
bool keeps_meaning(const Change& change, const Tokens& tokens) {
  const auto& all = tokens.all();
  if (change.removed == 0)
    return !begins_line(change.added.front()) || tokens.first_on_line(all[change.at]) ||
           all[change.at]->getType() == antlr4::Token::EOF;
  for (std::size_t at = change.at; at < change.at + change.removed; ++at) {
    const bool replaced =
        !change.added.empty() && all[at]->getType() != Parser::NUMBER && all[at]->getType() != Parser::STRING;
    if (!replaced && !says_nothing(at, tokens)) return false;
  }
  return true;
}

}  // namespace

Diagnostic told_by(const Change& change, const Mistake& mistake, const Tokens& tokens) {
  Diagnostic finding = mistake.finding;
  if (mistake.foreign || change.one_of_several) return finding;
  const auto* at = tokens.all()[change.at];
  const bool safe = keeps_meaning(change, tokens);
  if (change.removed == 0 && !safe) return finding;
  const bool is_known = std::none_of(change.added.begin(), change.added.end(), stands_for_many);
  if (change.removed == 0) {
    const auto added = is_known ? words_of(change.added) : spelling_of_type(change.added.front());
    if (finding.finding != Finding::missing_end) {
      const auto words = is_known ? "'" + added + "'" : added;
      const auto* before = tokens.before(at);
      const bool after = before != nullptr && tokens.first_on_line(at);
      finding.where = tokens.span(after ? before : at);
      finding.say({either<Finding::missing_after, Finding::missing_before>(after), words,
                   spelling(after ? *before : *at), added});
      if (is_unit_of_time(change, tokens))
        finding.say({Finding::unit_of_time_missing, spelling(*tokens.before(at))});
    } else {
      finding.say(
          {Finding::missing_end, finding.arguments[0], finding.arguments[1], finding.arguments[2], added});
    }
    if (is_known) finding.fix = {insertion(change, mistake, tokens)};
    return finding;
  }
  finding.where = tokens.span(at, tokens.all()[change.at + change.removed - 1]);
  if (safe) finding.fix = {{finding.where, words_of(change.added)}};
  if (change.added.empty()) {
    const PartialDiagnostic surplus{either<Finding::surplus_word, Finding::unexpected>(safe), spelling(*at)};
    if (change.at != mistake.at) finding.say(surplus);
    finding.hint = hint_of(surplus);
  } else {
    finding.say({Finding::misspelt_word, spelling(*at), words_of(change.added)});
  }
  return finding;
}

}  // namespace pal::syntax
