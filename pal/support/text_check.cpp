#include "pal/support/text_check.hpp"

#include "pal/support/finding.hpp"
#include "pal/support/utf8.hpp"

namespace pal {

bool report_unless_text(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  const auto text = sources.text(file);
  const auto report = [&](std::size_t at, FindingWith<0> what) {
    const auto begin = static_cast<std::uint32_t>(at);
    diagnostics.report(what, {file, begin, begin + 1});
    return false;
  };
  if (const auto zero = text.find('\0'); zero != std::string_view::npos) {
    return report(zero, Finding::nul_byte);
  }
  if (const auto wrong = utf8::first_invalid(text)) return report(*wrong, Finding::not_utf_eight);
  return true;
}

}  // namespace pal
