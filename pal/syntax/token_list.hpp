// Tokens from a list instead of from a text, so that a mended text can be parsed. Private to pal/syntax:
// shows ANTLR.
#pragma once

#include <antlr4-runtime.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pal::syntax {

/// At token `at`, `removed` tokens are removed, and tokens of these types are inserted. An inserted token has
/// no text of its own.
struct Change {
  std::size_t at = 0;
  std::size_t removed = 0;
  std::vector<std::size_t> added;
  bool one_of_several = false;  // another word would do as well
};

/// A token that stands for no text: an added one, or one that the parser made up itself.
bool is_made_up(const antlr4::Token* token);

/// Gives END the type that depends on the word after it. Gives the type HEADER to the first of two kind words
/// that are followed by a name and a colon. The lexer cannot see these.
void tell_words_apart(const std::vector<antlr4::Token*>& all);

/// Copies of tokens [begin, end) of `all` after `change`, which may be nullptr; then the end of the file,
/// which is the last of `all`.
std::vector<std::unique_ptr<antlr4::Token>> copy(const std::vector<antlr4::Token*>& all, std::size_t begin,
                                                 std::size_t end, const Change* change);

/// A source of these tokens; the last is the end of the file.
class TokenList : public antlr4::TokenSource {
 public:
  TokenList(std::vector<std::unique_ptr<antlr4::Token>> tokens, antlr4::TokenSource& text)
      : tokens_(std::move(tokens)), text_(text) {}

  std::unique_ptr<antlr4::Token> nextToken() override;
  std::size_t getLine() const override { return text_.getLine(); }
  std::size_t getCharPositionInLine() override { return text_.getCharPositionInLine(); }
  antlr4::CharStream* getInputStream() override { return text_.getInputStream(); }
  std::string getSourceName() override { return text_.getSourceName(); }
  antlr4::TokenFactory<antlr4::CommonToken>* getTokenFactory() override { return text_.getTokenFactory(); }

 private:
  std::vector<std::unique_ptr<antlr4::Token>> tokens_;
  antlr4::TokenSource& text_;
  std::size_t next_ = 0;
};

}  // namespace pal::syntax
