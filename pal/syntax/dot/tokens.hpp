// The words and signs of Graphviz' DOT language, with their places.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "pal/support/finding.hpp"
#include "pal/support/source.hpp"

namespace pal::syntax {

struct DotToken {
  enum class Kind {
    word,    // a name or a number as it stands
    quoted,  // without its quotes; \" is a quote, and a line that ends in \ goes on in the next
    html,    // an HTML string, with its brackets
    sign,
    end
  };
  Kind kind = Kind::end;
  std::string text;
  SourceSpan where;
};

/// The text is not DOT from here on. Never leaves pal/syntax.
struct NotDot {
  SourceSpan where;
  PartialDiagnostic what;
};

class DotLexer {
 public:
  DotLexer(FileId file, std::string_view text);

  /// The next token; after the last one tokens of kind end. Throws NotDot.
  DotToken next();

 private:
  bool at(std::string_view sign) const { return text_.substr(at_).starts_with(sign); }
  SourceSpan span(std::size_t begin) const;
  DotToken token(DotToken::Kind kind, std::size_t begin) const;
  void skip();
  DotToken name();
  DotToken number();
  DotToken quoted();
  DotToken html();
  DotToken sign();

  FileId file_;
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace pal::syntax
