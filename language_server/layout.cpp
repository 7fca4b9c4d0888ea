// The canonical layout, as the edits that lead to it.
#include <algorithm>
#include <string_view>
#include <vector>

#include "language_server/session.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/syntax/format.hpp"

namespace pal::language_server {

namespace {

/// With their breaks.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = text.find('\n');
    lines.push_back(text.substr(0, end == std::string_view::npos ? text.size() : end + 1));
    text.remove_prefix(lines.back().size());
  }
  return lines;
}

/// Lines [begin, end) of the old text, and what comes in their place.
struct Hunk {
  std::size_t begin, end;
  std::string text;
};

/// The fewest lines, by the longest common subsequence; one hunk where the table would be large.
std::vector<Hunk> hunks(const std::vector<std::string_view>& before, const std::vector<std::string_view>& after) {
  std::size_t head = 0;
  while (head < before.size() && head < after.size() && before[head] == after[head]) ++head;
  std::size_t tail = 0;
  while (tail < before.size() - head && tail < after.size() - head &&
         before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
    ++tail;
  const std::size_t n = before.size() - head - tail;
  const std::size_t m = after.size() - head - tail;
  std::vector<Hunk> result;
  const auto put = [&](std::size_t begin, std::size_t end, std::size_t from, std::size_t to) {
    std::string text;
    for (std::size_t i = from; i < to; ++i) text += after[i];
    result.push_back({begin, end, std::move(text)});
  };
  if (n == 0 && m == 0) return result;
  constexpr std::size_t largest = 4'000'000;
  if (n * m > largest || n == 0 || m == 0) {
    put(head, head + n, head, head + m);
    return result;
  }
  std::vector<std::uint32_t> length((n + 1) * (m + 1), 0);
  const auto at = [&](std::size_t i, std::size_t k) -> std::uint32_t& { return length[i * (m + 1) + k]; };
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = m; k-- > 0;)
      at(i, k) = before[head + i] == after[head + k] ? at(i + 1, k + 1) + 1 : std::max(at(i + 1, k), at(i, k + 1));
  }
  std::size_t i = 0, k = 0;
  while (i < n || k < m) {
    const std::size_t i0 = i, k0 = k;
    while (i < n || k < m) {
      if (i < n && k < m && before[head + i] == after[head + k]) break;
      if (k == m || (i < n && at(i + 1, k) >= at(i, k + 1))) {
        ++i;
      } else {
        ++k;
      }
    }
    if (i > i0 || k > k0) put(head + i0, head + i, head + k0, head + k);
    while (i < n && k < m && before[head + i] == after[head + k]) ++i, ++k;
  }
  return result;
}

/// The edits of lines [first, last] that lay a text out; nothing if it has errors.
Json edits(const Text& text, std::size_t first, std::size_t last) {
  SourceManager sources;
  Diagnostics diagnostics;
  const FileId file = sources.add("text", text.content());
  const auto formatted = syntax::format(sources, file, diagnostics);
  if (!formatted) return nullptr;
  const auto before = lines_of(text.content());
  std::vector<std::size_t> starts{0};
  for (const auto& line : before) starts.push_back(starts.back() + line.size());
  Json result = Json::array();
  for (const auto& hunk : hunks(before, lines_of(*formatted))) {
    if (hunk.begin > last || (hunk.end <= first && hunk.begin < first)) continue;
    result.push_back(text_edit(text, starts[hunk.begin], starts[hunk.end], hunk.text));
  }
  return result;
}

}  // namespace

Json Session::formatting(const Json& params) {
  const auto text = workspace_.text(path_in(params));
  return text == nullptr ? Json() : edits(*text, 0, text->lines());
}

Json Session::range_formatting(const Json& params) {
  const auto text = workspace_.text(path_in(params));
  if (text == nullptr) return nullptr;
  const Json& range = member(params, "range");
  return edits(*text, position_of(member(range, "start")).line, position_of(member(range, "end")).line);
}

}  // namespace pal::language_server
