#include "pal/support/text_width.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "pal/support/utf8.hpp"

namespace pal {

namespace {

struct Range {
  char32_t first;
  char32_t last;
};

// Unicode 15: combining marks and joiners of the scripts in common use.
constexpr std::array zero_width{
    Range{0x0300, 0x036F}, Range{0x0483, 0x0489}, Range{0x0591, 0x05BD}, Range{0x0610, 0x061A},
    Range{0x064B, 0x065F}, Range{0x0900, 0x0902}, Range{0x1AB0, 0x1AFF}, Range{0x1DC0, 0x1DFF},
    Range{0x200B, 0x200F}, Range{0x202A, 0x202E}, Range{0x2060, 0x2064}, Range{0x20D0, 0x20FF},
    Range{0xFE00, 0xFE0F}, Range{0xFE20, 0xFE2F}, Range{0xFEFF, 0xFEFF}, Range{0xE0100, 0xE01EF}};

// Unicode 15, EastAsianWidth W and F, and emoji.
constexpr std::array double_width{
    Range{0x1100, 0x115F},   Range{0x2E80, 0x303E},   Range{0x3041, 0x33FF},   Range{0x3400, 0x4DBF},
    Range{0x4E00, 0x9FFF},   Range{0xA000, 0xA4CF},   Range{0xA960, 0xA97F},   Range{0xAC00, 0xD7A3},
    Range{0xF900, 0xFAFF},   Range{0xFE30, 0xFE6F},   Range{0xFF00, 0xFF60},   Range{0xFFE0, 0xFFE6},
    Range{0x1F300, 0x1F64F}, Range{0x1F680, 0x1F6FF}, Range{0x1F900, 0x1F9FF}, Range{0x20000, 0x3FFFD}};

template <class Ranges>
bool in(const Ranges& ranges, char32_t c) {
  const auto after = std::upper_bound(ranges.begin(), ranges.end(), c,
                                      [](char32_t value, const Range& r) { return value < r.first; });
  return after != ranges.begin() && c <= std::prev(after)->last;
}

constexpr int tab = 4;

bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0);
}

// Marks that turn the direction of text would make an excerpt lie about what it shows.
bool turns_direction(char32_t c) {
  return (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

bool is_replaced(const utf8::Decoded& next) {
  return !next.valid || is_control(next.code_point) || turns_direction(next.code_point);
}

}  // namespace

int width(char32_t c) {
  if (c < 0x300) return 1;
  if (in(zero_width, c)) return 0;
  return in(double_width, c) ? 2 : 1;
}

int width(std::string_view text) {
  int column = 0;
  while (!text.empty()) {
    const auto next = utf8::decode(text);
    text.remove_prefix(next.bytes);
    if (next.code_point == U'\t') {
      column += tab - column % tab;
    } else {
      column += is_replaced(next) ? 1 : width(next.code_point);
    }
  }
  return column;
}

std::string printable(std::string_view text) {
  std::string result;
  int column = 0;
  while (!text.empty()) {
    const auto next = utf8::decode(text);
    if (next.code_point == U'\t') {
      const int step = tab - column % tab;
      result.append(static_cast<std::size_t>(step), ' ');
      column += step;
    } else if (is_replaced(next)) {
      result += "\xEF\xBF\xBD";
      ++column;
    } else {
      result += text.substr(0, next.bytes);
      column += width(next.code_point);
    }
    text.remove_prefix(next.bytes);
  }
  return result;
}

}  // namespace pal
