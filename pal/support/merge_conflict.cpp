#include "pal/support/merge_conflict.hpp"

#include <algorithm>
#include <cstdint>

#include "pal/support/finding.hpp"

namespace pal {
namespace {

bool is_marker(std::string_view line, char sign) {
  constexpr std::size_t length = 7;
  return line.size() >= length && line.find_first_not_of(sign) >= length && line[0] == sign &&
         (line.size() == length || line[length] == ' ');
}

}  // namespace

bool report_merge_conflict(std::string_view text, FileId file, Diagnostics& diagnostics) {
  const auto span = [file](std::size_t begin, std::size_t end) {
    return SourceSpan{file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
  };
  Diagnostic* finding = nullptr;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    if (finding == nullptr) {
      if (is_marker(line, '<')) finding = &diagnostics.report(Finding::merge_conflict, span(begin, end));
    } else if (finding->notes.size() < 2 && (is_marker(line, '=') || is_marker(line, '>'))) {
      finding->note(span(begin, end), Remark::goes_on_here);
    }
    begin = std::min(text.find('\n', end), text.size() - 1) + 1;
  }
  return finding != nullptr;
}

}  // namespace pal
