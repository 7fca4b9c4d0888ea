// The words of a text, with its comments, as they stand: for colours, folding and what an editor asks.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace pal::syntax {

/// keyword: reserved, or one that begins a unit. contextual: a keyword in its places, else a name.
struct TextToken {
  enum class Kind : std::uint8_t { keyword, contextual, name, number, text, sign, comment, stray };
  Kind kind = Kind::name;
  std::uint32_t begin = 0;  // bytes [begin, end) of the text
  std::uint32_t end = 0;
};

/// All of them in order, of any text. Never throws. Bytes that are no UTF-8 are read as U+FFFD.
std::vector<TextToken> text_tokens(std::string_view text);

}  // namespace pal::syntax
