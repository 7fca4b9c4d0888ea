#include "pal/support/text_check.hpp"

#include "pal/support/diagnostic_code.hpp"
#include "pal/support/utf8.hpp"

namespace pal {

bool report_unless_text(const SourceManager& sources, FileId file, Diagnostics& diagnostics) {
  const auto text = sources.text(file);
  const auto report = [&](std::size_t at, const char* what) {
    const auto begin = static_cast<std::uint32_t>(at);
    diagnostics.report(Code::PAL0112, {file, begin, begin + 1}, what, "save the file as UTF-8 text");
    return false;
  };
  if (const auto zero = text.find('\0'); zero != std::string_view::npos) {
    return report(zero, "a NUL byte cannot stand in a text");
  }
  if (const auto wrong = utf8::first_invalid(text)) return report(*wrong, "this byte is not UTF-8");
  return true;
}

}  // namespace pal
