#include "pal/syntax/gaps.hpp"

#include "pal/support/utf8.hpp"

namespace pal::syntax {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::size_t code_points(std::string_view text) {
  std::size_t count = 0;
  while (!text.empty()) {
    text.remove_prefix(utf8::decode(text).bytes);
    ++count;
  }
  return count;
}

std::string_view without_end_spaces(std::string_view text) {
  const auto last = text.find_last_not_of(" \t\f\v");
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

/// Where the line that begins at `begin` ends, without its line break; lone carriage returns break lines too.
std::size_t end_of_line(std::string_view text, std::size_t begin) {
  return std::min(text.find_first_of("\r\n", begin), text.size());
}

std::size_t after_line_break(std::string_view text, std::size_t end) {
  return text.substr(end, 2) == "\r\n" ? end + 2 : end + 1;
}

}  // namespace

Gap read_gap(std::string_view text, bool at_start) {
  if (at_start && text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  Gap gap;
  bool first_line = true;
  bool blank = false;
  for (std::size_t begin = 0;;) {
    const auto end = end_of_line(text, begin);
    const auto line = text.substr(begin, end - begin);
    const bool last_line = end == text.size();
    if (const auto mark = line.find('#'); mark != std::string_view::npos) {
      const bool trailing = first_line && !at_start;
      gap.comments.push_back({std::string(without_end_spaces(line.substr(mark))), trailing,
                              code_points(line.substr(0, mark)), blank});
      blank = false;
    } else if (!last_line && (!first_line || at_start)) {
      blank = true;
    }
    if (last_line) {
      if (!first_line || at_start) gap.token_column = code_points(line);
      break;
    }
    begin = after_line_break(text, end);
    first_line = false;
  }
  gap.blank_before_token = blank;
  return gap;
}

}  // namespace pal::syntax
