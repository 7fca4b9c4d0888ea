#include "pal/support/xml.hpp"

#include "pal/support/utf8.hpp"

namespace pal {
namespace {

/// Char of XML 1.0. The end of a line in the manner of DOS is left to text editors.
bool may_stand(const utf8::Decoded& next) {
  const char32_t c = next.code_point;
  if (!next.valid || c == 0xFFFE || c == 0xFFFF) return false;
  return c >= 0x20 || c == U'\n' || c == U'\t';
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto next = utf8::decode(text);
    switch (next.code_point) {
      case U'&':
        result += "&amp;";
        break;
      case U'<':
        result += "&lt;";
        break;
      case U'>':
        result += "&gt;";
        break;
      case U'"':
        result += "&quot;";
        break;
      default:
        if (may_stand(next))
          result += text.substr(0, next.bytes);
        else
          result += "\uFFFD";
    }
    text.remove_prefix(next.bytes);
  }
  return result;
}

}  // namespace pal
