#include "pal/support/utf8.hpp"

namespace pal::utf8 {

namespace {

struct Form {
  std::size_t bytes;
  char32_t bits;
  char32_t least;  // smaller code points have a shorter form
};

std::optional<Form> form(unsigned char first) {
  if (first < 0x80) return Form{1, first, 0};
  if (first < 0xC2) return std::nullopt;
  if (first < 0xE0) return Form{2, static_cast<char32_t>(first & 0x1F), 0x80};
  if (first < 0xF0) return Form{3, static_cast<char32_t>(first & 0x0F), 0x800};
  if (first < 0xF5) return Form{4, static_cast<char32_t>(first & 0x07), 0x10000};
  return std::nullopt;
}

}  // namespace

Decoded decode(std::string_view text) {
  constexpr Decoded broken{0xFFFD, 1, false};
  const auto lead = form(static_cast<unsigned char>(text.front()));
  if (!lead || text.size() < lead->bytes) return broken;
  char32_t value = lead->bits;
  for (std::size_t i = 1; i < lead->bytes; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0) != 0x80) return broken;
    value = (value << 6) | (byte & 0x3Fu);
  }
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (value < lead->least || surrogate || value > 0x10FFFF) return broken;
  return {value, lead->bytes, true};
}

std::size_t length(std::string_view text) {
  std::size_t count = 0;
  while (!text.empty()) {
    text.remove_prefix(decode(text).bytes);
    ++count;
  }
  return count;
}

std::optional<std::size_t> first_invalid(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto next = decode(text.substr(at));
    if (!next.valid) return at;
    at += next.bytes;
  }
  return std::nullopt;
}

}  // namespace pal::utf8
