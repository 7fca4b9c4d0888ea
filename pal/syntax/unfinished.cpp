#include "pal/syntax/unfinished.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "PalParser.h"
#include "pal/support/finding.hpp"
#include "pal/syntax/first_mistake.hpp"
#include "pal/syntax/repair.hpp"
#include "pal/syntax/spelling.hpp"

namespace pal::syntax {
namespace {

using Parser = grammar::PalParser;

/// Line ends that are looked at: that before the mistake, and some before it.
constexpr std::size_t most_lines = 3;
/// The longest line is finished by fewer words: a whole requirement.
constexpr std::size_t most_words = 16;

/// No sentence of PAL has it.
constexpr std::size_t wall = Parser::STRAY;

/// Which of the words that may go on finishes a line soonest.
constexpr std::array quick{Parser::RIGHT, Parser::COLON, Parser::TO,   Parser::FROM,   Parser::OF,
                           Parser::AT,    Parser::MOST,  Parser::NAME, Parser::NUMBER, Parser::STRING};

std::size_t quickest(const std::set<std::size_t>& expected) {
  const auto found =
      std::find_if(quick.begin(), quick.end(), [&](std::size_t type) { return expected.contains(type); });
  return found == quick.end() ? *expected.begin() : static_cast<std::size_t>(*found);
}

/// Where these may stand, nothing is unfinished.
bool is_finished(const std::set<std::size_t>& expected) {
  static constexpr std::array ends{Parser::END,     Parser::END_CASE, Parser::END_CONCURRENT,
                                   Parser::END_WTM, Parser::UNTIL,    Parser::HEADER};
  return std::any_of(ends.begin(), ends.end(), [&](std::size_t type) { return expected.contains(type); });
}

/// What may stand behind the tokens from the unit's beginning to `at`, with `added` put in there. Nothing if
/// the parser does not get so far.
std::optional<GoingOn> behind(std::size_t at, std::vector<std::size_t> added, const Mistake& mistake,
                              Tokens& tokens) {
  added.push_back(wall);
  const Change change{at, 1, std::move(added)};
  const std::size_t place = at - mistake.unit_begin + change.added.size() - 1;
  return going_on_at(place, copy(tokens.all(), mistake.unit_begin, at + 1, &change), tokens.text());
}

/// Whether the line that begins at `at` begins something. It does with a keyword or a text, and where it is
/// not indented deeper than the line before. It also does behind a parenthesis that this line leaves open.
bool begins_anew(std::size_t at, std::size_t line_before, const Tokens& tokens) {
  const auto& all = tokens.all();
  int open = 0;
  for (auto i = line_before; i < at; ++i)
    open += all[i]->getType() == Parser::LEFT ? 1 : all[i]->getType() == Parser::RIGHT ? -1 : 0;
  const auto type = all[at]->getType();
  return open > 0 || type < Parser::LEFT || type == Parser::STRING || type == antlr4::Token::EOF ||
         all[at]->getCharPositionInLine() <= all[line_before]->getCharPositionInLine();
}

/// A line that ends something ends itself.
bool begins_with_end(std::size_t line, const Tokens& tokens) {
  static constexpr std::array ends{Parser::END, Parser::END_CASE, Parser::END_CONCURRENT, Parser::END_WTM};
  return std::find(ends.begin(), ends.end(), tokens.all()[line]->getType()) != ends.end();
}

Diagnostic told(std::size_t at, const GoingOn& expected, const Tokens& tokens) {
  const auto* last = tokens.all()[at - 1];
  const std::string words = expected.spelling.empty() ? "more" : expected.spelling;
  Diagnostics one;
  return one.report(Finding::expected_after, tokens.span(last), words, spelling(*last));
}

/// What finishes the line before `at`, if the parser gets into the line after the mistake then. `words` go on
/// there.
std::optional<Change> finished_by(std::vector<std::size_t> words, std::size_t at, const Mistake& mistake,
                                  Tokens& tokens) {
  Change change{at, 0, std::move(words)};
  while (!gets_past(change, mistake, tokens)) {
    const auto next = behind(at, change.added, mistake, tokens);
    if (!next || next->types.empty() || is_finished(next->types) || change.added.size() == most_words)
      return std::nullopt;
    change.added.push_back(quickest(next->types));
  }
  return change;
}

std::optional<UnfinishedLine> unfinished_before(std::size_t at, const Mistake& mistake, Tokens& tokens) {
  const auto first = behind(at, {}, mistake, tokens);
  if (!first || first->types.empty() || is_finished(first->types)) return std::nullopt;
  const auto word = quickest(first->types);
  auto change = finished_by({word}, at, mistake, tokens);
  // SKILL begins a template, or the header of a module.
  if (!change && first->types.contains(Parser::MODULE))
    change = finished_by({Parser::MODULE, Parser::COLON}, at, mistake, tokens);
  if (!change) return std::nullopt;
  UnfinishedLine line{*change, told(at, *first, tokens)};
  const bool certain = word == Parser::RIGHT || word == Parser::COLON || first->types.size() == 1;
  if (change->added.size() == 1 && certain) {
    Mistake here = mistake;
    here.foreign = false;
    here.finding = line.finding;
    line.finding = told_by(*change, here, tokens);
  }
  return line;
}

}  // namespace

std::optional<UnfinishedLine> unfinished_line(const Mistake& mistake, Tokens& tokens) {
  if (!may_be_mended(mistake)) return std::nullopt;
  const auto& all = tokens.all();
  std::vector<std::size_t> begins;  // of lines, the last first
  for (auto at = mistake.at; at > mistake.unit_begin && begins.size() <= most_lines; --at) {
    if (tokens.first_on_line(all[at])) begins.push_back(at);
  }
  if (begins.size() <= most_lines) begins.push_back(mistake.unit_begin);
  for (auto line = begins.size() - 1; line-- > 0;) {
    // What a line has in place of PAL's own form tells more than what is missing behind it.
    if (mistake.foreign && mistake.finding.where.begin < tokens.span(all[begins[line]]).begin) continue;
    if (begins_with_end(begins[line + 1], tokens)) continue;
    if (!begins_anew(begins[line], begins[line + 1], tokens)) continue;
    if (auto found = unfinished_before(begins[line], mistake, tokens)) return found;
  }
  return std::nullopt;
}

}  // namespace pal::syntax
