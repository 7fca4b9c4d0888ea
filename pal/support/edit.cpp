#include "pal/support/edit.hpp"

#include <algorithm>

namespace pal {

std::string apply(std::vector<Edit> edits, FileId file, std::string_view text) {
  std::erase_if(edits, [&](const Edit& edit) { return edit.where.file != file; });
  std::stable_sort(edits.begin(), edits.end(),
                   [](const Edit& a, const Edit& b) { return a.where.begin < b.where.begin; });
  std::string result;
  std::size_t done = 0;
  for (const Edit& edit : edits) {
    const std::size_t begin = edit.where.begin;
    if (begin < done || edit.where.end > text.size()) continue;
    result += text.substr(done, begin - done);
    result += edit.text;
    done = edit.where.end;
  }
  result += text.substr(done);
  return result;
}

}  // namespace pal
