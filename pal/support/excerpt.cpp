#include "pal/support/excerpt.hpp"

#include <algorithm>

#include "pal/support/text_width.hpp"

namespace pal {
namespace {

// Of a line longer than this only the part around the place is shown.
constexpr std::size_t excerpt_bytes = 160;
constexpr std::size_t excerpt_lead = 60;

std::size_t back_to_code_point(std::string_view line, std::size_t at) {
  while (at > 0 && at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0) == 0x80) --at;
  return at;
}

}  // namespace

Excerpt excerpt(std::string_view line, std::size_t begin, std::size_t end) {
  begin = std::min(begin, line.size());
  end = std::clamp(end, begin, line.size());
  std::size_t first = 0;
  std::size_t last = line.size();
  if (line.size() > excerpt_bytes) {
    first = back_to_code_point(line, begin > excerpt_lead ? begin - excerpt_lead : 0);
    last = back_to_code_point(line, std::min(line.size(), first + excerpt_bytes));
    end = std::clamp(end, begin, last);
  }
  const std::string_view lead = first > 0 ? "..." : "";
  const std::string_view tail = last < line.size() ? "..." : "";
  const auto before = std::string(lead) + std::string(line.substr(first, begin - first));
  const auto through = before + std::string(line.substr(begin, end - begin));
  const auto shown = through + std::string(line.substr(end, last - end));
  const int column = width(before);
  return {printable(shown) + std::string(tail), column, std::max(1, width(through) - column)};
}

}  // namespace pal
