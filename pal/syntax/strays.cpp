#include "pal/syntax/strays.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "pal/support/finding.hpp"
#include "pal/support/merge_conflict.hpp"
#include "pal/support/utf8.hpp"
#include "pal/syntax/foreign_signs.hpp"
#include "pal/syntax/tokens.hpp"

namespace pal::syntax {
namespace {

using Lexer = grammar::PalLexer;

constexpr std::size_t most_strays = 100;

/// Where the line that begins at `begin` ends, without its end of line.
std::size_t end_of_line(std::string_view text, std::size_t begin) {
  return std::min(text.find_first_of("\r\n", begin), text.size());
}

bool starts_with_any(std::string_view line, std::initializer_list<std::string_view> beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view beginning) { return line.starts_with(beginning); });
}

SourceSpan span_of(FileId file, std::size_t begin, std::size_t end) {
  return {file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

bool report_markup(std::string_view text, FileId file, Diagnostics& diagnostics) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (begin == std::string_view::npos) return false;
  const std::string_view start = text.substr(begin, 15);
  if (!starts_with_any(start, {"<html", "<HTML", "<!DOCTYPE", "<!doctype", "<?xml", "<body", "<pre"}))
    return false;
  diagnostics.report(Finding::web_page, span_of(file, begin, end_of_line(text, begin)));
  return true;
}

bool is_dash(std::string_view sign) {
  static const std::set<std::string_view> dashes{"‐", "‑", "–", "—", "−"};
  return dashes.contains(sign);
}

/// Latin letters without their marks, and a plain hyphen for a dash; what else there is becomes '_'.
std::string plain(std::string_view name) {
  static const std::map<std::string_view, std::string_view> letters{
      {"à", "a"}, {"á", "a"}, {"â", "a"},  {"ã", "a"}, {"ä", "a"}, {"å", "a"}, {"ç", "c"}, {"è", "e"},
      {"é", "e"}, {"ê", "e"}, {"ë", "e"},  {"ì", "i"}, {"í", "i"}, {"î", "i"}, {"ï", "i"}, {"ñ", "n"},
      {"ò", "o"}, {"ó", "o"}, {"ô", "o"},  {"õ", "o"}, {"ö", "o"}, {"ø", "o"}, {"ù", "u"}, {"ú", "u"},
      {"û", "u"}, {"ü", "u"}, {"ß", "ss"}, {"µ", "u"}, {"μ", "u"}};
  std::string result;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t bytes = utf8::decode(name.substr(at)).bytes;
    const std::string_view letter = name.substr(at, bytes);
    const auto found = letters.find(letter);
    const bool may_stay = bytes == 1 && (std::isalnum(static_cast<unsigned char>(letter[0])) != 0 ||
                                         letter == "_" || letter == "-");
    result += found != letters.end() ? found->second : may_stay ? letter : is_dash(letter) ? "-" : "_";
    at += bytes;
  }
  return result;
}

/// Reserved words, and those that begin a unit.
bool may_not_name_activity(std::size_t type) {
  return type >= Lexer::WTM && type <= Lexer::ENVIRONMENT;
}

class Reader {
 public:
  Reader(const Tokens& tokens, std::string_view text, Diagnostics& diagnostics)
      : tokens_(tokens), all_(tokens.all()), text_(text), diagnostics_(diagnostics) {}

  Strays read() {
    for (std::size_t at = 0; at < all_.size() && result_.parseable;) at = read_at(at) + 1;
    return std::move(result_);
  }

 private:
  /// What begins at token `at`; gives its last token.
  std::size_t read_at(std::size_t at) {
    if (const auto last = foreign(at)) return *last;
    switch (all_[at]->getType()) {
      case Lexer::OPEN_STRING:
        return open_text(at);
      case Lexer::SLASH:
        return foreign_comment(at);
      case Lexer::ACTIVITY:
        return activity(at);
      case Lexer::STRAY:
        if (const auto last = quoted_text(at)) return *last;
        return run(at);
      case Lexer::NAME:
        if (const auto last = name_with_strays(at)) return *last;
        return at;
      default:
        return renamed(at);
    }
  }

  /// Null when the limit of reports is reached: the rest is passed over.
  Diagnostic* report(const PartialDiagnostic& what, SourceSpan where) {
    result_.has_errors = true;
    if (++reported_ < most_strays) return &diagnostics_.report(what, where);
    diagnostics_.report(Finding::too_many_unexpected_characters, where);
    result_.parseable = false;
    return nullptr;
  }

  std::optional<std::size_t> foreign(std::size_t at) {
    auto sign = foreign_sign(tokens_, text_, at);
    if (!sign) return std::nullopt;
    if (auto* finding = report(sign->what, sign->where)) finding->fix = std::move(sign->fix);
    for (Rereading& each : sign->rereadings) result_.rereadings.push_back(std::move(each));
    return sign->last;
  }

  std::size_t open_text(std::size_t at) {
    const SourceSpan where = tokens_.span(all_[at]);
    auto* finding = report({Finding::no_closing_quote}, where);
    if (finding != nullptr) finding->fix = {{span_of(where.file, where.end, where.end), "\""}};
    result_.rereadings.push_back({at, at, Lexer::STRING, all_[at]->getText()});
    return at;
  }

  /// /* … */, which may go over lines.
  std::size_t foreign_comment(std::size_t at) {
    if (!is(at + 1, Lexer::STAR) || !touch(at)) return at;
    std::size_t last = at + 1;
    while (last + 2 < all_.size() && !(is(last, Lexer::STAR) && is(last + 1, Lexer::SLASH) && touch(last)))
      ++last;
    const bool closed = is(last, Lexer::STAR) && is(last + 1, Lexer::SLASH);
    last = closed ? last + 1 : at + 1;
    report({Finding::no_block_comments}, tokens_.span(all_[at], all_[at + 1]));
    result_.rereadings.push_back({at, last, 0, {}});
    return last;
  }

  /// A text in quotes of a word processor; all of it stands on one line.
  std::optional<std::size_t> quoted_text(std::size_t at) {
    static const std::set<std::string_view> opening{"“", "”", "„", "«", "‘", "’"};
    static const std::set<std::string_view> closing{"“", "”", "»", "‘", "’", "\""};
    const SourceSpan open = tokens_.span(all_[at]);
    if (!opening.contains(source(open))) return std::nullopt;
    for (std::size_t last = at + 1; last + 1 < all_.size() && all_[last]->getLine() == all_[at]->getLine();
         ++last) {
      SourceSpan close = tokens_.span(all_[last]);
      if (!closing.contains(source(close).substr(0, 3)) && source(close)[0] != '"') continue;
      if (source(close)[0] == '"') close.end = close.begin + 1;
      const std::string inside(text_.substr(open.end, close.begin - open.end));
      if (auto* finding =
              report({Finding::straight_quotes, inside}, span_of(open.file, open.begin, close.end)))
        finding->fix = {{open, "\""}, {close, "\""}};
      result_.rereadings.push_back({at, last, Lexer::STRING, "\"" + inside + "\""});
      return last;
    }
    return std::nullopt;
  }

  /// The last token of the word that begins at `at`: names, and what no name may have.
  std::size_t end_of_word(std::size_t at) const {
    std::size_t last = at;
    while (touch(last) && (is(last + 1, Lexer::NAME) || is(last + 1, Lexer::NUMBER) || is_in_word(last + 1)))
      ++last;
    while (last > at && is(last, Lexer::STRAY) && !is_letter(last)) --last;
    return last;
  }

  bool has_stray(std::size_t first, std::size_t last) const {
    for (std::size_t at = first; at <= last; ++at)
      if (is(at, Lexer::STRAY)) return true;
    return false;
  }

  /// A name with letters that no name may have; told once for each name.
  std::optional<std::size_t> name_with_strays(std::size_t at) {
    const std::size_t last = end_of_word(at);
    if (!has_stray(at, last)) return std::nullopt;
    return name(at, last);
  }

  std::size_t name(std::size_t first, std::size_t last) {
    const SourceSpan where = tokens_.span(all_[first], all_[last]);
    const std::string written(source(where));
    const std::string meant = plain(written);
    result_.has_errors = true;
    if (told_.insert(written).second) {
      const bool sure = meant.find('_') == std::string::npos || written.find('_') != std::string::npos;
      auto* finding = sure ? report({Finding::letters_for_others, written, meant}, where)
                           : report({Finding::letters_of_no_name, written}, where);
      if (finding != nullptr && sure) finding->fix = everywhere(written, meant);
    }
    result_.rereadings.push_back({first, last, Lexer::NAME, meant});
    return last;
  }

  /// The edits that replace a word at each of its places.
  std::vector<Edit> everywhere(const std::string& written, const std::string& meant) const {
    std::vector<Edit> edits;
    for (std::size_t at = 0; at + 1 < all_.size(); ++at) {
      if ((!is(at, Lexer::NAME) && !is_letter(at)) || (at > 0 && touch(at - 1) && is_in_word(at - 1)))
        continue;
      const SourceSpan where = tokens_.span(all_[at], all_[end_of_word(at)]);
      if (source(where) == written) edits.push_back({where, meant});
    }
    return edits;
  }

  /// ACTIVITY message: a word that may not name an activity. Where it is one, it is read as a name from here
  /// on.
  std::size_t activity(std::size_t at) {
    if (at + 1 >= all_.size() || !may_not_name_activity(all_[at + 1]->getType())) return at;
    if (tokens_.first_on_line(all_[at + 1])) return at;  // the name is missing
    const auto* word = all_[at + 1];
    report({Finding::word_names_activity, word->getText()}, tokens_.span(word));
    result_.rereadings.push_back({at + 1, at + 1, Lexer::NAME, word->getText()});
    renamed_.insert(word->getType());
    return at + 1;
  }

  /// Where such a word stands for an activity: alone on its line, behind AT or behind TIME.
  std::size_t renamed(std::size_t at) {
    if (!renamed_.contains(all_[at]->getType())) return at;
    const bool alone =
        tokens_.first_on_line(all_[at]) && at + 1 < all_.size() && tokens_.first_on_line(all_[at + 1]);
    if (alone || (at > 0 && (is(at - 1, Lexer::AT) || is(at - 1, Lexer::TIME))))
      result_.rereadings.push_back({at, at, Lexer::NAME, all_[at]->getText()});
    return at;
  }

  /// Anything else.
  std::size_t run(std::size_t at) {
    if (is_letter(at) && touch(at) && (is(at + 1, Lexer::NAME) || is_letter(at + 1)))
      return name(at, end_of_word(at));
    std::size_t last = at;
    while (touch(last) && is(last + 1, Lexer::STRAY)) ++last;
    // It is not known what was meant, so that no edit is offered.
    report({either<Finding::unexpected_character, Finding::unexpected_characters>(last == at)},
           tokens_.span(all_[at], all_[last]));
    result_.rereadings.push_back({at, last, 0, {}});
    return last;
  }

  bool is(std::size_t at, std::size_t type) const { return at < all_.size() && all_[at]->getType() == type; }
  /// The next token begins where this one ends.
  bool touch(std::size_t at) const {
    return at + 1 < all_.size() && all_[at]->getStopIndex() + 1 == all_[at + 1]->getStartIndex() &&
           all_[at + 1]->getType() != antlr4::Token::EOF;
  }
  std::string_view source(SourceSpan where) const {
    return text_.substr(where.begin, where.end - where.begin);
  }
  /// A letter of another alphabet, as far as two bytes of UTF-8 tell: not a quote, a dash or a sign.
  bool is_letter(std::size_t at) const {
    if (!is(at, Lexer::STRAY)) return false;
    const std::string_view letter = source(tokens_.span(all_[at]));
    if (letter == "µ") return true;
    return letter.size() == 2 && static_cast<unsigned char>(letter[0]) >= 0xC3 && letter != "×" &&
           letter != "÷";
  }
  /// What a word goes on with although no name may have it: also a dash, and a sign that is no operator.
  bool is_in_word(std::size_t at) const {
    if (!is(at, Lexer::STRAY)) return false;
    if (is_letter(at)) return true;
    static const std::set<std::string_view> dividers{"&", "|", "!", "<", ">", "{", "}", "'", "“",  "”",
                                                     "„", "«", "»", "‘", "’", "≠", "≤", "≥", "·",  "×",
                                                     "÷", "²", "³", "°", "…", "¬", "∧", "∨", "\\", ";"};
    const std::string_view sign = source(tokens_.span(all_[at]));
    return !dividers.contains(sign) && !is_space(sign);
  }
  static bool is_space(std::string_view sign) {
    return sign == "\u00A0" || sign == "\u00AD" || sign == "\u3000" || sign.starts_with("\xE2\x80")
               ? !is_dash(sign)
               : false;
  }

  const Tokens& tokens_;
  const std::vector<antlr4::Token*>& all_;
  std::string_view text_;
  Diagnostics& diagnostics_;
  std::size_t reported_ = 0;
  std::set<std::string> told_;
  std::set<std::size_t> renamed_;  // words that name an activity
  Strays result_;
};

}  // namespace

Strays read_strays(const Tokens& tokens, std::string_view text, Diagnostics& diagnostics) {
  if (report_markup(text, tokens.file(), diagnostics) ||
      report_merge_conflict(text, tokens.file(), diagnostics))
    return {false, true, {}};
  return Reader(tokens, text, diagnostics).read();
}

}  // namespace pal::syntax
