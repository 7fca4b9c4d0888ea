#include "pal/syntax/tokens.hpp"

#include <algorithm>
#include <string>

#include "pal/support/finding.hpp"
#include "pal/support/utf8.hpp"
#include "pal/syntax/parse.hpp"
#include "pal/syntax/strays.hpp"

namespace pal::syntax {

namespace {

using Lexer = grammar::PalLexer;

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::vector<std::uint32_t> code_point_offsets(std::string_view text) {
  const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  if (std::all_of(text.begin(), text.end(), is_ascii)) return {};
  std::vector<std::uint32_t> offsets;
  offsets.reserve(text.size());
  for (std::size_t at = 0; at < text.size(); at += utf8::decode(text.substr(at)).bytes) {
    offsets.push_back(static_cast<std::uint32_t>(at));
  }
  return offsets;
}

std::string_view without_mark(std::string_view text) {
  return text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size()) : text;
}

}  // namespace

Tokens::Tokens(FileId file, std::string_view text, Diagnostics& diagnostics)
    : file_(file),
      size_(static_cast<std::uint32_t>(text.size())),
      mark_bytes_(static_cast<std::uint32_t>(text.size() - without_mark(text).size())),
      byte_offsets_(code_point_offsets(without_mark(text))),
      input_(std::string(without_mark(text))),
      lexer_(&input_) {
  lexer_.removeErrorListeners();  // every character is a token, so there is nothing to listen to
  read(lexer_);
  report_length(diagnostics);
  const Strays strays = read_strays(*this, text, diagnostics);
  has_errors_ = has_errors_ || strays.has_errors;
  parseable_ = parseable_ && strays.parseable;
  if (!strays.rereadings.empty()) reread(strays.rereadings);
  if (parseable_) bound_nesting(diagnostics);
}

void Tokens::read(antlr4::TokenSource& source) {
  stream_ = std::make_unique<antlr4::CommonTokenStream>(&source);
  stream_->fill();
  all_ = stream_->getTokens();
  tell_words_apart(all_);
}

void Tokens::apply(const Change& change) {
  auto list = std::make_unique<TokenList>(copy(all_, 0, all_.size() - 1, &change), lexer_);
  read(*list);
  changed_ = std::move(list);
}

void Tokens::reread(const std::vector<Rereading>& rereadings) {
  const auto tokens = copy(all_, 0, all_.size() - 1, nullptr);
  std::vector<std::unique_ptr<antlr4::Token>> result;
  auto next = rereadings.begin();
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (next == rereadings.end() || i < next->first) {
      result.push_back(std::make_unique<antlr4::CommonToken>(tokens[i].get()));
      continue;
    }
    if (next->before != 0) {
      auto token = std::make_unique<antlr4::CommonToken>(tokens[next->first].get());
      token->setType(next->before);
      token->setText(next->before_text);
      result.push_back(std::move(token));
    }
    if (next->type != 0) {
      auto token = std::make_unique<antlr4::CommonToken>(tokens[next->first].get());
      token->setType(next->type);
      token->setStopIndex(tokens[next->last]->getStopIndex());
      token->setText(next->text);
      result.push_back(std::move(token));
    }
    i = next->last;
    ++next;
  }
  changed_ = std::make_unique<TokenList>(std::move(result), lexer_);
  read(*changed_);
}

std::uint32_t Tokens::byte(std::size_t code_point) const {
  if (byte_offsets_.empty()) return std::min(size_, mark_bytes_ + static_cast<std::uint32_t>(code_point));
  if (code_point >= byte_offsets_.size()) return size_;
  return mark_bytes_ + byte_offsets_[code_point];
}

SourceSpan Tokens::span(const antlr4::Token* token) const {
  return span(token, token);
}

SourceSpan Tokens::span(const antlr4::Token* first, const antlr4::Token* last) const {
  const auto made_up = [](const antlr4::Token* t) { return t->getTokenIndex() == INVALID_INDEX; };
  if (made_up(first) || made_up(last)) {
    if (!made_up(first)) return span(first);
    if (!made_up(last)) return span(last);
    return {file_, size_, size_};
  }
  const auto ends = [](const antlr4::Token* t) { return t->getType() == antlr4::Token::EOF; };
  const auto begin = ends(first) ? size_ : byte(first->getStartIndex());
  const auto end = ends(last) ? size_ : byte(last->getStopIndex() + 1);
  return {file_, begin, std::max(begin, end)};
}

antlr4::Token* Tokens::before(const antlr4::Token* token) const {
  const auto index = token->getTokenIndex();
  if (index == INVALID_INDEX || index == 0 || index > all_.size()) return nullptr;
  return all_[index - 1];
}

bool Tokens::first_on_line(const antlr4::Token* token) const {
  const auto* previous = before(token);
  return previous == nullptr || previous->getLine() != token->getLine();
}

void Tokens::report_length(Diagnostics& diagnostics) {
  if (!lexer_.is_cut()) return;
  diagnostics.report(Finding::file_too_long, span(all_[all_.size() - 2]), most_tokens);
  parseable_ = false;
  has_errors_ = true;
}

void Tokens::bound_nesting(Diagnostics& diagnostics) {
  int depth = 0;
  auto previous = antlr4::Token::EOF;
  for (const auto* token : all_) {
    const auto type = token->getType();
    switch (type) {
      case Lexer::BEGIN:
      case Lexer::REPEAT:
      case Lexer::LEFT:
        ++depth;
        break;
      case Lexer::CASE:
        if (previous != Lexer::END_CASE) ++depth;
        break;
      case Lexer::CONCURRENT:
        if (previous != Lexer::END_CONCURRENT) ++depth;
        break;
      case Lexer::WITHIN:  // WTM( X from M ) WITHIN … END WTM
        if (previous == Lexer::RIGHT) ++depth;
        break;
      case Lexer::FIRST:
        if (previous == Lexer::WTM) ++depth;
        break;
      case Lexer::END:
      case Lexer::END_CASE:
      case Lexer::END_CONCURRENT:
      case Lexer::END_WTM:
      case Lexer::UNTIL:
      case Lexer::RIGHT:
        depth = std::max(0, depth - 1);
        break;
      default:
        break;
    }
    if (depth > deepest_nesting) {
      const bool inside = type == Lexer::LEFT;
      diagnostics.report(either<Finding::parentheses_nested_too_deeply, Finding::nested_too_deeply>(inside),
                         span(token), deepest_nesting);
      parseable_ = false;
      has_errors_ = true;
      return;
    }
    previous = type;
  }
}

}  // namespace pal::syntax
