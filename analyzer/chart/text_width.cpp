#include "analyzer/chart/text_width.hpp"

#include <array>

namespace pal::analyzer::chart {

namespace {

// DejaVu Sans, U+0020 to U+007E, thousandths of the font size.
constexpr std::array<int, 95> advances = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838,
};
// What is not ASCII here is mostly signs: dashes, arrows, µ, the ellipsis.
constexpr int other_advance = 1000;

bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

int advance(char c) {
  const auto code = static_cast<unsigned char>(c);
  if (code >= 0x20 && code < 0x7F) return advances[code - 0x20u];
  return continues(c) ? 0 : other_advance;
}

}  // namespace

Length text_width(std::string_view text, Length font_size, bool bold) {
  Length thousandths = 0;
  for (const char c : text) thousandths += advance(c);
  if (bold) thousandths += thousandths / 6;
  return (thousandths * font_size + 999) / 1000;
}

std::string fitted(std::string_view text, Length font_size, Length width, bool bold) {
  if (text_width(text, font_size, bold) <= width) return std::string(text);
  const std::string ellipsis = "\u2026";
  const Length room = width - text_width(ellipsis, font_size, bold);
  std::size_t end = 0;
  Length thousandths = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    thousandths += advance(text[i]);
    const Length so_far = bold ? thousandths + thousandths / 6 : thousandths;
    if (so_far * font_size > room * 1000) break;
    if (i + 1 == text.size() || !continues(text[i + 1])) end = i + 1;
  }
  return end < 3 ? std::string() : std::string(text.substr(0, end)) + ellipsis;
}

std::vector<std::string> wrapped(std::string_view text, Length font_size, Length width, bool bold) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!lines.empty() && text_width(lines.back() + " " + word, font_size, bold) <= width) {
      lines.back() += " " + word;
    } else {
      lines.push_back(fitted(word, font_size, width, bold));
    }
  }
  return lines;
}

}  // namespace pal::analyzer::chart
