#include "pal/syntax/reading.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "pal/support/finding.hpp"
#include "pal/syntax/first_mistake.hpp"
#include "pal/syntax/repair.hpp"
#include "pal/syntax/unfinished.hpp"

namespace pal::syntax {

namespace {

using Parser = Reading::Parser;
using Simulator = antlr4::atn::ParserATNSimulator;

/// The quick way: SLL prediction without error recovery accepts nearly every correct text.
Parser::FileContext* parse_quickly(Parser& parser) {
  parser.getInterpreter<Simulator>()->setPredictionMode(antlr4::atn::PredictionMode::SLL);
  parser.setErrorHandler(std::make_shared<antlr4::BailErrorStrategy>());
  try {
    return parser.file();
  } catch (const antlr4::ParseCancellationException&) {
    return nullptr;
  }
}

// Mending tries many changes at each mistake, and reads the text again. A file with more mistakes, or of more
// tokens, would take too long.
constexpr std::size_t most_reports = 8;
constexpr std::size_t most_mended_tokens = 50'000;

bool is_one_of(const std::set<std::size_t>& types, const antlr4::Token* token) {
  return types.contains(token->getType());
}

/// Leaves out the line on which the mistake is told. Where that is the first line of a unit, the unit before
/// has no end, and is left out. What a line ends or begins is kept, with another test. Nothing at the end of
/// the file.
std::optional<Change> without_line(const Mistake& mistake, const Tokens& tokens) {
  static const std::set<std::size_t> short_units{Parser::USES, Parser::MESSAGE, Parser::CONDITION,
                                                 Parser::DEVICE};
  static const std::set<std::size_t> long_units{Parser::HEADER, Parser::SKILL, Parser::ENVIRONMENT};
  const auto& all = tokens.all();
  const auto begins_unit = [&](std::size_t token) {
    return is_one_of(short_units, all[token]) || is_one_of(long_units, all[token]);
  };
  const std::size_t end = all.size() - 1;
  std::size_t first = mistake.at;
  while (first > 0 && tokens.span(all[first]).begin > mistake.finding.where.begin) --first;
  while (first > 0 && !tokens.first_on_line(all[first])) --first;
  if (first >= end) return std::nullopt;
  if (mistake.unit_begin < first && is_one_of(short_units, all[mistake.unit_begin]) && begins_unit(first))
    return Change{mistake.unit_begin, first - mistake.unit_begin, {}};
  const auto goes_on_at = [&](std::size_t token) {
    return tokens.first_on_line(all[token]) && (!mistake.between || begins_unit(token));
  };
  std::size_t next = first + 1;
  while (next < end && !goes_on_at(next)) ++next;
  const auto begins = all[first]->getType();
  if (mistake.between || mistake.at >= next) return Change{first, next - first, {}};
  if (begins == Parser::UNTIL)
    return Change{first, next - first, {Parser::UNTIL, Parser::LEFT, Parser::FOREVER, Parser::RIGHT}};
  std::size_t colon = first;
  while (colon < next && all[colon]->getType() != Parser::COLON) ++colon;
  if (begins == Parser::LEFT && colon < mistake.at)
    return Change{colon + 1, next - colon - 1, {Parser::DO, Parser::NOTHING}};
  if (begins == Parser::LEFT && colon < next)
    return Change{first, colon - first, {Parser::LEFT, Parser::NAME, Parser::RIGHT}};
  return Change{first, next - first, {}};
}

/// A sign that is missing. Other changes may make something else of the lines around: a heading of a
/// statement, for one.
bool adds_sign(const Change& change) {
  return change.removed == 0 && change.added.size() == 1 && change.added.front() >= Parser::LEFT &&
         change.added.front() < Parser::NAME;
}

/// Reports one mistake after the other. Each is mended before the next is looked for, or else its line is
/// left out. Returns whether one was, or may have another meaning now, or the text behind one was left out.
bool report_mistakes(Tokens& tokens, Diagnostics& diagnostics) {
  const bool is_long = tokens.all().size() > most_mended_tokens;
  bool lost = false;
  for (std::size_t reported = 0;; ++reported) {
    const auto mistake = first_mistake(tokens);
    if (!mistake) return lost;
    if (is_made_up(tokens.all()[mistake->at])) return true;  // not the user's mistake
    if (reported == most_reports) {
      diagnostics.report(Finding::too_many_syntax_errors, mistake->finding.where);
      return true;
    }
    if (auto line = is_long ? std::nullopt : unfinished_line(*mistake, tokens)) {
      diagnostics.report(line->finding);
      tokens.apply(line->change);
      continue;
    }
    auto change = is_long ? std::nullopt : repair_of(*mistake, tokens);
    diagnostics.report(change ? told_by(*change, *mistake, tokens) : mistake->finding);
    lost = lost || !change || !adds_sign(*change);
    if (!change) change = without_line(*mistake, tokens);
    if (!change || is_long) return true;
    tokens.apply(*change);
  }
}

/// What stands before the first unit with a mistake that is left.
Parser::FileContext* parse_carefully(Parser& parser, const Tokens& tokens) {
  parser.getInterpreter<Simulator>()->setPredictionMode(antlr4::atn::PredictionMode::LL);
  const auto strategy = std::make_shared<FirstMistake>(tokens);
  parser.setErrorHandler(strategy);
  try {
    return parser.file();
  } catch (const antlr4::ParseCancellationException&) {
    return strategy->file;
  }
}

}  // namespace

Reading::Reading(FileId file, std::string_view text, Diagnostics& diagnostics)
    : tokens_(file, text, diagnostics) {
  if (!tokens_.parseable()) return;
  const auto errors_before = diagnostics.errors();
  parser_.emplace(&tokens_.stream());
  parser_->removeErrorListeners();  // the strategies report for themselves
  root_ = parse_quickly(*parser_);
  if (root_ == nullptr) {
    lost_ = report_mistakes(tokens_, diagnostics);
    tokens_.stream().seek(0);
    parser_.emplace(&tokens_.stream());
    parser_->removeErrorListeners();
    root_ = parse_carefully(*parser_, tokens_);
  }
  lost_ = lost_ || tokens_.has_errors();
  complete_ = !tokens_.has_errors() && diagnostics.errors() == errors_before;
}

}  // namespace pal::syntax
