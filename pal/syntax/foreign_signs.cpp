#include "pal/syntax/foreign_signs.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include "pal/syntax/tokens.hpp"

namespace pal::syntax {
namespace {

using Lexer = grammar::PalLexer;

/// A sign of one or two tokens, and the word that PAL has for it.
struct Operator {
  std::string_view written;
  std::string_view word;
  std::size_t type;
  std::string_view before{};  // a word before that one
  std::size_t before_type = 0;
};

/// Longer ones first.
constexpr std::array operators{Operator{"&&", "AND", Lexer::AND},
                               Operator{"||", "OR", Lexer::OR},
                               Operator{"<=", "MOST", Lexer::MOST, "AT", Lexer::AT},
                               Operator{">=", "LEAST", Lexer::LEAST, "AT", Lexer::AT},
                               Operator{"≤", "MOST", Lexer::MOST, "AT", Lexer::AT},
                               Operator{"≥", "LEAST", Lexer::LEAST, "AT", Lexer::AT},
                               Operator{"&", "AND", Lexer::AND},
                               Operator{"∧", "AND", Lexer::AND},
                               Operator{"|", "OR", Lexer::OR},
                               Operator{"∨", "OR", Lexer::OR},
                               Operator{"!", "NOT", Lexer::NOT},
                               Operator{"¬", "NOT", Lexer::NOT},
                               Operator{"·", "*", Lexer::STAR},
                               Operator{"×", "*", Lexer::STAR},
                               Operator{"÷", "/", Lexer::SLASH},
                               Operator{"²", "2", Lexer::NUMBER, "^", Lexer::CARET},
                               Operator{"³", "3", Lexer::NUMBER, "^", Lexer::CARET}};

bool divides_figures(std::string_view sign) {
  static constexpr std::array<std::string_view, 7> dashes{"-", "‐", "‑", "–", "—", "−", "~"};
  return std::find(dashes.begin(), dashes.end(), sign) != dashes.end();
}

/// Spaces that look like one of the keyboard's.
std::string_view name_of_space(std::string_view sign) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> spaces{
      {{"\u00A0", "a no-break space"},
       {"\u202F", "a narrow no-break space"},
       {"\u2007", "a figure space"},
       {"\u2009", "a thin space"},
       {"\u2002", "an en space"},
       {"\u2003", "an em space"},
       {"\u3000", "an ideographic space"},
       {"\u200A", "a hair space"}}};
  const auto found =
      std::find_if(spaces.begin(), spaces.end(), [&](const auto& space) { return space.first == sign; });
  return found == spaces.end() ? std::string_view() : found->second;
}

std::string_view name_of_invisible(std::string_view sign) {
  if (sign == "\u200B") return "a zero-width space";
  if (sign == "\u200C" || sign == "\u200D") return "a zero-width joiner";
  if (sign == "\u2060") return "a word joiner";
  if (sign == "\u00AD") return "a soft hyphen";
  return {};
}

class Sign {
 public:
  Sign(const Tokens& tokens, std::string_view text, std::size_t at)
      : tokens_(tokens), all_(tokens.all()), text_(text), at_(at) {}

  std::optional<ForeignSign> read() const {
    switch (all_[at_]->getType()) {
      case Lexer::STRAY:
        if (auto space = unusual_space()) return space;
        if (auto dash = figures(at_, at_)) return dash;
        if (auto minus = minus_sign()) return minus;
        if (auto unequal = not_equal()) return unequal;
        if (auto degrees = degree_sign()) return degrees;
        if (auto brace = braces()) return brace;
        return word_for_operator();
      case Lexer::DOT:
        return dots();
      case Lexer::NUMBER:
        if (auto based = other_base()) return based;
        if (auto groups = grouped_digits()) return groups;
        return joined_figures();
      case Lexer::EQUAL:
        return double_equal();
      default:
        return std::nullopt;
    }
  }

 private:
  bool is(std::size_t at, std::size_t type) const { return at < all_.size() && all_[at]->getType() == type; }
  /// The next token begins where this one ends.
  bool touch(std::size_t at) const {
    return at + 1 < all_.size() && all_[at]->getStopIndex() + 1 == all_[at + 1]->getStartIndex() &&
           all_[at + 1]->getType() != antlr4::Token::EOF;
  }
  bool touches_before(std::size_t at) const { return at > 0 && touch(at - 1); }
  SourceSpan span(std::size_t first, std::size_t last) const { return tokens_.span(all_[first], all_[last]); }
  std::string_view source(std::size_t first, std::size_t last) const {
    const SourceSpan where = span(first, last);
    return text_.substr(where.begin, where.end - where.begin);
  }
  std::string_view source(std::size_t at) const { return source(at, at); }

  /// `word` with blanks where it would touch what stands beside it.
  std::string apart(std::size_t first, std::size_t last, std::string_view word) const {
    return std::string(touches_before(first) ? " " : "") + std::string(word) + (touch(last) ? " " : "");
  }

  ForeignSign sign(std::size_t last, PartialDiagnostic what) const {
    return {last, span(at_, last), std::move(what), {}, {}};
  }

  std::optional<ForeignSign> unusual_space() const {
    const std::string_view space = name_of_space(source(at_));
    const std::string_view invisible = name_of_invisible(source(at_));
    if (space.empty() && invisible.empty()) return std::nullopt;
    auto result = sign(at_, {either<Finding::invisible_sign, Finding::unusual_space>(space.empty()),
                             space.empty() ? invisible : space});
    // What is seen is one word: whether it was meant as one cannot be known.
    if (!space.empty() || !touches_before(at_) || !touch(at_))
      result.fix = {{result.where, space.empty() ? "" : " "}};
    result.rereadings = {{at_, at_, 0, {}}};
    return result;
  }

  /// The figure that stands before token `first`, perhaps with a unit between; nothing if there is none.
  std::optional<std::size_t> figure_before(std::size_t first) const {
    if (first == 0) return std::nullopt;
    std::size_t at = first - 1;
    if (is(at, Lexer::NAME) && !touches_before(first)) {
      while (touches_before(at) && is(at - 1, Lexer::STRAY)) --at;  // µs
      if (at == 0) return std::nullopt;
      --at;
    }
    return is(at, Lexer::NUMBER) && all_[at]->getLine() == all_[first]->getLine() ? std::optional(at)
                                                                                  : std::nullopt;
  }

  /// Whether an interval may go on behind `last`: a figure stands there, and one before `first`.
  bool between_figures(std::size_t first, std::size_t last) const {
    return figure_before(first) && is(last + 1, Lexer::NUMBER) &&
           all_[last + 1]->getLine() == all_[last]->getLine();
  }

  ForeignSign interval(std::size_t first, std::size_t last) const {
    const std::string from(source(*figure_before(first), first - 1));
    auto result = sign(last, {Finding::interval_sign, from, source(last + 1)});
    result.fix = {{result.where, apart(first, last, "TO")}};
    result.rereadings = {{first, last, Lexer::TO, "TO"}};
    return result;
  }

  std::optional<ForeignSign> figures(std::size_t first, std::size_t last) const {
    const std::string_view written = source(first, last);
    if (!divides_figures(written) && written != "…" && written != "‥") return std::nullopt;
    if (!between_figures(first, last)) return std::nullopt;
    return interval(first, last);
  }

  /// 1..2 and 1...2
  std::optional<ForeignSign> dots() const {
    std::size_t last = at_;
    while (touch(last) && is(last + 1, Lexer::DOT)) ++last;
    if (last == at_ || !between_figures(at_, last)) return std::nullopt;
    return interval(at_, last);
  }

  /// 1-2: the lexer reads a figure and a negative one.
  std::optional<ForeignSign> joined_figures() const {
    if (!touch(at_) || !is(at_ + 1, Lexer::NUMBER) || source(at_ + 1)[0] != '-') return std::nullopt;
    const std::string to(source(at_ + 1).substr(1));
    const SourceSpan second = span(at_ + 1, at_ + 1);
    auto result = sign(at_ + 1, {Finding::joined_figures, source(at_), to});
    result.fix = {{{second.file, second.begin, second.begin + 1}, " TO "}};
    result.rereadings = {{at_ + 1, at_ + 1, Lexer::NUMBER, to, Lexer::TO, "TO"}};
    return result;
  }

  /// A minus sign or a dash before a figure.
  std::optional<ForeignSign> minus_sign() const {
    const std::string_view written = source(at_);
    if (!divides_figures(written) || written == "~" || written == "-" || !touch(at_) ||
        !is(at_ + 1, Lexer::NUMBER))
      return std::nullopt;
    if (touches_before(at_)) return std::nullopt;  // a part of a word
    const std::string meant = "-" + std::string(source(at_ + 1));
    auto result = sign(at_, {Finding::minus_sign, meant});
    // A time is never negative: then something else was meant.
    static constexpr std::array<std::string_view, 5> times{"ns", "us", "ms", "s", "min"};
    const bool is_time =
        is(at_ + 2, Lexer::NAME) && std::find(times.begin(), times.end(), source(at_ + 2)) != times.end();
    if (!is_time) result.fix = {{result.where, "-"}};
    result.rereadings = {{at_, at_ + 1, Lexer::NUMBER, meant}};
    result.last = at_ + 1;
    return result;
  }

  /// a != FALSE
  std::optional<ForeignSign> not_equal() const {
    const bool one = source(at_) == "≠";
    const bool two = source(at_) == "!" && touch(at_) && is(at_ + 1, Lexer::EQUAL);
    if (!one && !two) return std::nullopt;
    const std::size_t last = two ? at_ + 1 : at_;
    const bool truth = is(last + 1, Lexer::TRUE) || is(last + 1, Lexer::FALSE);
    const bool becomes_true = is(last + 1, Lexer::FALSE);
    auto result =
        sign(last, truth ? PartialDiagnostic(Finding::unequal_to_truth, becomes_true ? "TRUE" : "FALSE")
                         : PartialDiagnostic(Finding::unequal));
    result.rereadings = {{at_, last, Lexer::EQUAL, "="}};
    if (truth) {
      result.rereadings.push_back(
          {last + 1, last + 1, becomes_true ? Lexer::TRUE : Lexer::FALSE, becomes_true ? "TRUE" : "FALSE"});
      result.last = last + 1;
    }
    return result;
  }

  std::optional<ForeignSign> double_equal() const {
    if (!touch(at_) || !is(at_ + 1, Lexer::EQUAL)) return std::nullopt;
    auto result = sign(at_ + 1, {Finding::double_equal});
    result.fix = {{result.where, "="}};
    result.rereadings = {{at_, at_ + 1, Lexer::EQUAL, "="}};
    return result;
  }

  std::optional<ForeignSign> degree_sign() const {
    if (source(at_) != "°" || at_ == 0 || !is(at_ - 1, Lexer::NUMBER)) return std::nullopt;
    const bool celsius = touch(at_) && is(at_ + 1, Lexer::NAME) && source(at_ + 1) == "C";
    const std::size_t last = celsius ? at_ + 1 : at_;
    const std::string unit = celsius ? "degC" : "deg";
    auto result = sign(last, {Finding::degree_sign, unit});
    result.fix = {{result.where, (touches_before(at_) ? " " : "") + unit}};
    result.rereadings = {{at_, last, Lexer::NAME, unit}};
    return result;
  }

  /// A body in braces. One that stands alone on its line is the body's beginning or end.
  std::optional<ForeignSign> braces() const {
    const bool opens = source(at_) == "{";
    if (!opens && source(at_) != "}") return std::nullopt;
    const std::string word = opens ? "BEGIN" : "END";
    auto result = sign(at_, {Finding::brace});
    const std::size_t type = opens ? Lexer::BEGIN : Lexer::END;
    const bool beside = is(at_ + 1, type) || (at_ > 0 && is(at_ - 1, type));
    const bool alone = tokens_.first_on_line(all_[at_]) && tokens_.first_on_line(all_[at_ + 1]);
    if (beside) {
      result.what = {Finding::brace_beside_word, word};
      result.fix = {{result.where, ""}};
    } else if (alone) {
      result.what = {Finding::brace_for_word, word};
      result.fix = {{result.where, word}};
      result.rereadings = {{at_, at_, type, word}};
      return result;
    }
    result.rereadings = {{at_, at_, 0, {}}};
    return result;
  }

  std::optional<ForeignSign> word_for_operator() const {
    for (const Operator& each : operators) {
      std::size_t last = at_;
      while (touch(last) && source(at_, last).size() < each.written.size()) ++last;
      if (source(at_, last) != each.written) continue;
      if (each.type == Lexer::NOT && !is(last + 1, Lexer::NAME) && !is(last + 1, Lexer::LEFT)) continue;
      if (each.before_type == Lexer::AT && !is(last + 1, Lexer::NUMBER)) continue;
      const bool joined = each.type == Lexer::STAR || each.type == Lexer::SLASH || each.type == Lexer::NUMBER;
      if (joined && !touches_before(at_) && each.type == Lexer::NUMBER) continue;
      const std::string glue = each.before_type == Lexer::AT ? " " : "";
      const std::string word = std::string(each.before) + glue + std::string(each.word);
      auto result = sign(last, {Finding::sign_for_word, word, each.written});
      result.fix = {{result.where, joined ? word : apart(at_, last, word)}};
      result.rereadings = {
          {at_, last, each.type, std::string(each.word), each.before_type, std::string(each.before)}};
      return result;
    }
    return std::nullopt;
  }

  /// 0x10 and 0b101: the lexer reads 0 and a name.
  std::optional<ForeignSign> other_base() const {
    if (source(at_) != "0" || !touch(at_) || !is(at_ + 1, Lexer::NAME)) return std::nullopt;
    const std::string_view name = source(at_ + 1);
    const int base = name[0] == 'x' || name[0] == 'X' ? 16 : name[0] == 'b' || name[0] == 'B' ? 2 : 0;
    if (base == 0 || name.size() < 2) return std::nullopt;
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), value, base);
    if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
    const std::string decimal = std::to_string(value);
    auto result = sign(at_ + 1, {Finding::other_base, decimal});
    result.fix = {{result.where, decimal}};
    result.rereadings = {{at_, at_ + 1, Lexer::NUMBER, decimal}};
    return result;
  }

  /// 1_000 and 1'000. The hint says what is meant; a group of another length is none.
  std::optional<ForeignSign> grouped_digits() const {
    std::string digits(source(at_));
    std::size_t last = at_;
    const auto is_group = [](std::string_view part) {
      return part.size() == 3 &&
             std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
    };
    while (touch(last)) {
      const std::string_view next = source(last + 1);
      if (next[0] == '_') {
        std::string_view rest = next;
        std::string more;
        while (rest.size() >= 4 && rest[0] == '_' && is_group(rest.substr(1, 3))) {
          more += rest.substr(1, 3);
          rest.remove_prefix(4);
        }
        if (!rest.empty()) break;
        digits += more;
        ++last;
      } else if (next == "'" && touch(last + 1) && is(last + 2, Lexer::NUMBER) &&
                 is_group(source(last + 2))) {
        digits += source(last + 2);
        last += 2;
      } else {
        break;
      }
    }
    if (last == at_) return std::nullopt;
    auto result = sign(last, {Finding::grouped_digits, digits});
    result.rereadings = {{at_, last, Lexer::NUMBER, digits}};
    return result;
  }

  const Tokens& tokens_;
  const std::vector<antlr4::Token*>& all_;
  std::string_view text_;
  std::size_t at_;
};

}  // namespace

std::optional<ForeignSign> foreign_sign(const Tokens& tokens, std::string_view text, std::size_t at) {
  return Sign(tokens, text, at).read();
}

}  // namespace pal::syntax
