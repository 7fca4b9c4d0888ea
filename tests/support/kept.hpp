// The skills that the tests keep, mostly because they broke something once.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/kinds.hpp"
#include "tests/support/project_file.hpp"

namespace pal::test {

/// Their texts, each a whole skill with its environment, in a fixed order.
inline const std::vector<std::string>& kept_skills() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> texts;
    const std::filesystem::path root = PAL_SOURCE_DIR;
    for (const char* folder : {"differential", "reference", "golden/check", "property/sandwich"}) {
      for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "tests" / folder)) {
        if (entry.path().extension() != ".pal") continue;
        const std::string text = project_file(std::filesystem::relative(entry.path(), root).string());
        if (has_meaning(text)) texts.push_back(text);
      }
    }
    std::sort(texts.begin(), texts.end());
    return texts;
  }();
  return all;
}

}  // namespace pal::test
