#include "pal/syntax/text_tokens.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <unordered_map>

#include "PalLexer.h"
#include "pal/support/utf8.hpp"

namespace pal::syntax {

namespace {

using Lexer = grammar::PalLexer;

/// The keywords by their spelling in capitals, from the lexer's own list of types.
const std::unordered_map<std::string, std::size_t>& keywords() {
  static const std::unordered_map<std::string, std::size_t> table = [] {
    antlr4::ANTLRInputStream input;
    const Lexer lexer(&input);
    std::unordered_map<std::string, std::size_t> result;
    for (std::size_t type = Lexer::WTM; type < Lexer::LEFT; ++type)
      result.emplace(std::string(lexer.getVocabulary().getSymbolicName(type)), type);
    return result;
  }();
  return table;
}

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool is_word(char c) {
  return is_letter(c) || is_digit(c);
}

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::vector<TextToken> scan() {
    while (at_ < text_.size()) next();
    return std::move(tokens_);
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void add(TextToken::Kind kind, std::size_t end) {
    tokens_.push_back({kind, static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(end)});
    at_ = end;
  }

  void next() {
    const char c = peek();
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v') {
      ++at_;
    } else if (text_.substr(at_, 3) == "\xEF\xBB\xBF") {
      at_ += 3;
    } else if (c == '#') {
      auto end = std::min(text_.find_first_of("\r\n", at_), text_.size());
      add(TextToken::Kind::comment, end);
    } else if (is_letter(c)) {
      word();
    } else if (is_digit(c) || (c == '-' && is_digit(peek(1)))) {
      add(TextToken::Kind::number, number_end());
    } else if (c == '"') {
      add(TextToken::Kind::text, string_end());
    } else if (std::string_view("():;,=*/^.%[]").find(c) != std::string_view::npos) {
      add(TextToken::Kind::sign, at_ + 1);
    } else {
      add(TextToken::Kind::stray, at_ + utf8::decode(text_.substr(at_)).bytes);
    }
  }

  void word() {
    std::size_t end = at_;
    while (end < text_.size() && is_word(text_[end])) ++end;
    while (end + 1 < text_.size() && text_[end] == '-' && is_word(text_[end + 1])) {
      ++end;
      while (end < text_.size() && is_word(text_[end])) ++end;
    }
    std::string capitals(text_.substr(at_, end - at_));
    for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const auto known = keywords().find(capitals);
    add(known == keywords().end()             ? TextToken::Kind::name
        : known->second >= Lexer::ACTIVITY ? TextToken::Kind::contextual
                                              : TextToken::Kind::keyword,
        end);
  }

  std::size_t digits_end(std::size_t end) const {
    while (end < text_.size() && is_digit(text_[end])) ++end;
    return end;
  }

  std::size_t number_end() const {
    auto end = digits_end(at_ + 1);
    if (end + 1 < text_.size() && text_[end] == '.' && is_digit(text_[end + 1])) end = digits_end(end + 1);
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
      auto exponent = end + 1;
      if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
      if (exponent < text_.size() && is_digit(text_[exponent])) end = digits_end(exponent);
    }
    return end;
  }

  /// Also of a text that is not closed on its line.
  std::size_t string_end() const {
    auto end = at_ + 1;
    while (end < text_.size() && text_[end] != '"' && text_[end] != '\r' && text_[end] != '\n') {
      const bool escape = text_[end] == '\\' && end + 1 < text_.size() && text_[end + 1] != '\r' &&
                          text_[end + 1] != '\n';
      end += escape ? 2 : 1;
    }
    return end < text_.size() && text_[end] == '"' ? end + 1 : end;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<TextToken> tokens_;
};

}  // namespace

std::vector<TextToken> text_tokens(std::string_view text) {
  return Scanner(text).scan();
}

}  // namespace pal::syntax
