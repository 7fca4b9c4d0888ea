// The tokens of one file, made ready for the parser. Private to pal/syntax: shows ANTLR.
#pragma once

#include <antlr4-runtime.h>

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "PalLexer.h"
#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"
#include "pal/syntax/token_list.hpp"

namespace pal::syntax {

struct Rereading;

/// The most words and signs of one file that are read: some 300,000 lines.
constexpr std::size_t most_tokens = 2'000'000;

/// The lexer of the grammar, which ends the text after `most_tokens`.
class BoundedLexer : public grammar::PalLexer {
 public:
  using grammar::PalLexer::PalLexer;

  std::unique_ptr<antlr4::Token> nextToken() override {
    if (count_++ >= most_tokens && !hitEOF) {
      is_cut_ = true;
      hitEOF = true;
    }
    return grammar::PalLexer::nextToken();
  }
  bool is_cut() const { return is_cut_; }

 private:
  std::size_t count_ = 0;
  bool is_cut_ = false;
};

/// Owns the text as ANTLR wants it, the lexer and the tokens; maps tokens to bytes of the text.
class Tokens {
 public:
  /// Reads all tokens. Reports text that is no token of PAL, and nesting deeper than `deepest_nesting`.
  Tokens(FileId file, std::string_view text, Diagnostics& diagnostics);

  /// False if these tokens must not be given to a parser.
  bool parseable() const { return parseable_; }
  bool has_errors() const { return has_errors_; }

  antlr4::CommonTokenStream& stream() { return *stream_; }
  /// In the order of the text; the last is the end of the file.
  const std::vector<antlr4::Token*>& all() const { return all_; }
  antlr4::TokenSource& text() { return lexer_; }
  /// Applies a change and makes a new stream; what came from the old stream becomes invalid.
  void apply(const Change& change);
  FileId file() const { return file_; }

  /// Of a token, also the one for the end of the file. Of one that the parser made up: the end of the token
  /// before.
  SourceSpan span(const antlr4::Token* token) const;
  /// From the first byte of one to the last of the other.
  SourceSpan span(const antlr4::Token* first, const antlr4::Token* last) const;
  /// The token before this one, or nullptr.
  antlr4::Token* before(const antlr4::Token* token) const;
  bool first_on_line(const antlr4::Token* token) const;

 private:
  std::uint32_t byte(std::size_t code_point) const;
  void read(antlr4::TokenSource& source);
  void reread(const std::vector<Rereading>& rereadings);
  void report_length(Diagnostics& diagnostics);
  void bound_nesting(Diagnostics& diagnostics);

  FileId file_;
  std::uint32_t size_;
  std::uint32_t mark_bytes_;                 // of a byte order mark, which ANTLR does not count
  std::vector<std::uint32_t> byte_offsets_;  // of each code point; empty if all are one byte
  antlr4::ANTLRInputStream input_;
  BoundedLexer lexer_;
  std::unique_ptr<TokenList> changed_;  // where the stream comes from after a change
  std::unique_ptr<antlr4::CommonTokenStream> stream_;
  std::vector<antlr4::Token*> all_;
  bool parseable_ = true;
  bool has_errors_ = false;
};

}  // namespace pal::syntax
