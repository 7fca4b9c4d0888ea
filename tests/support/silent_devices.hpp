// Makes devices that may not answer of those that answer on request.
#pragma once

#include <regex>
#include <string>

namespace pal::test {

inline std::string with_silent_devices(const std::string& text) {
  static const std::regex asked(R"((\n\s*DEVICE\s+[\w-]+\s+ON REQUEST\s[^\n#]*))");
  return std::regex_replace(text, asked, "$1 OR NEVER");
}

}  // namespace pal::test
