#include "pal/syntax/dot/tokens.hpp"

#include <algorithm>
#include <utility>

namespace pal::syntax {

namespace {

constexpr std::string_view dot_byte_order_mark = "\xEF\xBB\xBF";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool begins_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) > 127;
}
bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

}  // namespace

DotLexer::DotLexer(FileId file, std::string_view text) : file_(file), text_(text) {
  if (at(dot_byte_order_mark)) at_ = dot_byte_order_mark.size();
}

DotToken DotLexer::next() {
  skip();
  if (at_ == text_.size()) return {DotToken::Kind::end, "", span(at_)};
  const char c = text_[at_];
  if (c == '"') return quoted();
  if (c == '<') return html();
  if (begins_name(c)) return name();
  const auto digit_at = [&](std::size_t i) { return i < text_.size() && is_digit(text_[i]); };
  const std::size_t figures = at_ + (c == '-' ? 1 : 0);
  const bool fraction = figures < text_.size() && text_[figures] == '.' && digit_at(figures + 1);
  if (digit_at(figures) || fraction) return number();
  return sign();
}

SourceSpan DotLexer::span(std::size_t begin) const {
  return {file_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)};
}

DotToken DotLexer::token(DotToken::Kind kind, std::size_t begin) const {
  return {kind, std::string(text_.substr(begin, at_ - begin)), span(begin)};
}

/// White space, comments as in C++, and lines that begin with '#' as a preprocessor's do.
void DotLexer::skip() {
  while (at_ < text_.size()) {
    const bool line_begins = at_ == 0 || text_[at_ - 1] == '\n';
    if (is_space(text_[at_])) {
      ++at_;
    } else if (at("//") || (line_begins && at("#"))) {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (at("/*")) {
      const std::size_t begin = at_;
      const std::size_t end = text_.find("*/", at_ + 2);
      if (end == std::string_view::npos) {
        at_ += 2;
        throw NotDot{span(begin), {Finding::comment_without_end}};
      }
      at_ = end + 2;
    } else {
      return;
    }
  }
}

DotToken DotLexer::name() {
  const std::size_t begin = at_;
  while (at_ < text_.size() && (begins_name(text_[at_]) || is_digit(text_[at_]))) ++at_;
  return token(DotToken::Kind::word, begin);
}

DotToken DotLexer::number() {
  const std::size_t begin = at_;
  if (text_[at_] == '-') ++at_;
  while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
  if (at(".")) ++at_;
  while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
  return token(DotToken::Kind::word, begin);
}

DotToken DotLexer::quoted() {
  const std::size_t begin = at_++;
  std::string value;
  while (at_ < text_.size() && text_[at_] != '"') {
    if (at("\\\"")) {
      value += '"';
      at_ += 2;
    } else if (at("\\\\")) {  // both stay: what they mean is a matter of the attribute
      value += "\\\\";
      at_ += 2;
    } else if (at("\\\n")) {
      at_ += 2;
    } else if (at("\\\r\n")) {
      at_ += 3;
    } else {
      value += text_[at_++];
    }
  }
  if (at_ >= text_.size()) {
    at_ = begin + 1;
    throw NotDot{span(begin), {Finding::text_without_quote}};
  }
  ++at_;
  return {DotToken::Kind::quoted, std::move(value), span(begin)};
}

DotToken DotLexer::html() {
  const std::size_t begin = at_;
  std::size_t depth = 0;
  for (; at_ < text_.size(); ++at_) {
    if (text_[at_] == '<') ++depth;
    if (text_[at_] == '>' && --depth == 0) {
      ++at_;
      return token(DotToken::Kind::html, begin);
    }
  }
  at_ = begin + 1;
  throw NotDot{span(begin), {Finding::html_without_end}};
}

DotToken DotLexer::sign() {
  const std::size_t begin = at_;
  at_ += at("->") || at("--") ? 2 : 1;
  return token(DotToken::Kind::sign, begin);
}

}  // namespace pal::syntax
