#include "pal/support/line_difference.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pal {

namespace {

using Lines = std::vector<std::string_view>;

Lines lines_to_compare(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

/// One line of the shortest way from one text to the other; `mark` as in a diff.
struct MarkedLine {
  char mark = ' ';
  std::string_view line;
};

/// The texts differ in many lines: all of the one, then all of the other. A diff of them would be no shorter.
constexpr std::ptrdiff_t most_differences = 2000;

std::vector<MarkedLine> replaced(const Lines& before, const Lines& after) {
  std::vector<MarkedLine> edits;
  for (const auto line : before) edits.push_back({'-', line});
  for (const auto line : after) edits.push_back({'+', line});
  return edits;
}

/// Myers, An O(ND) difference algorithm and its variations (1986), figure 2.
std::vector<MarkedLine> shortest_edits(const Lines& before, const Lines& after) {
  const auto n = static_cast<std::ptrdiff_t>(before.size());
  const auto m = static_cast<std::ptrdiff_t>(after.size());
  const auto most = std::min(n + m, most_differences);
  // furthest[k + most + 1]: how far in `before` diagonal k was reached; history[d]: that before step d.
  std::vector<std::ptrdiff_t> furthest(static_cast<std::size_t>(2 * most + 3), 0);
  std::vector<std::vector<std::ptrdiff_t>> history;
  const auto at = [&](std::ptrdiff_t k) { return static_cast<std::size_t>(k + most + 1); };
  const auto goes_down = [&](const auto& reached, std::ptrdiff_t k, std::ptrdiff_t d) {
    return k == -d || (k != d && reached[at(k - 1)] < reached[at(k + 1)]);
  };
  const auto same = [&](std::ptrdiff_t x, std::ptrdiff_t y) {
    return before[static_cast<std::size_t>(x)] == after[static_cast<std::size_t>(y)];
  };
  std::ptrdiff_t steps = -1;
  for (std::ptrdiff_t d = 0; d <= most && steps < 0; ++d) {
    history.push_back(furthest);
    for (std::ptrdiff_t k = -d; k <= d; k += 2) {
      auto x = goes_down(furthest, k, d) ? furthest[at(k + 1)] : furthest[at(k - 1)] + 1;
      while (x < n && x - k < m && same(x, x - k)) ++x;
      furthest[at(k)] = x;
      if (x >= n && x - k >= m) steps = d;
    }
  }
  if (steps < 0) return replaced(before, after);

  std::vector<MarkedLine> edits;
  auto x = n;
  auto y = m;
  for (auto d = steps; d >= 0; --d) {
    const auto& reached = history[static_cast<std::size_t>(d)];
    const auto k = x - y;
    const bool down = goes_down(reached, k, d);
    const auto from_x = down ? reached[at(k + 1)] : reached[at(k - 1)];
    const auto from_y = from_x - (down ? k + 1 : k - 1);
    for (; d == 0 ? x > 0 && y > 0 : x > from_x + (down ? 0 : 1) && y > from_y + (down ? 1 : 0); --x, --y) {
      edits.push_back({' ', before[static_cast<std::size_t>(x - 1)]});
    }
    if (d == 0) break;
    edits.push_back(down ? MarkedLine{'+', after[static_cast<std::size_t>(from_y)]}
                         : MarkedLine{'-', before[static_cast<std::size_t>(from_x)]});
    x = from_x;
    y = from_y;
  }
  std::reverse(edits.begin(), edits.end());
  return edits;
}

/// One piece of the diff with its head: edits [first, last), which begin in these lines of the texts, from 0.
std::string piece(const std::vector<MarkedLine>& edits, std::size_t first, std::size_t last,
                  std::size_t old_line, std::size_t new_line) {
  std::size_t olds = 0;
  std::size_t news = 0;
  std::string body;
  for (auto i = first; i < last; ++i) {
    olds += edits[i].mark != '+';
    news += edits[i].mark != '-';
    body += edits[i].mark;
    body += edits[i].line;
    if (!edits[i].line.ends_with('\n')) body += "\n\\ No newline at end of file\n";
  }
  const auto range = [](std::size_t line, std::size_t count) {
    return std::to_string(count == 0 ? line : line + 1) + "," + std::to_string(count);
  };
  return "@@ -" + range(old_line, olds) + " +" + range(new_line, news) + " @@\n" + body;
}

}  // namespace

std::vector<LineChange> line_changes(std::string_view before, std::string_view after) {
  std::vector<LineChange> changes;
  if (before == after) return changes;
  std::size_t at = 0;
  bool goes_on = false;
  for (const MarkedLine& edit : shortest_edits(lines_to_compare(before), lines_to_compare(after))) {
    const bool differs = edit.mark != ' ';
    if (differs && !goes_on) changes.push_back({at, at, {}});
    goes_on = differs;
    if (edit.mark == '+') {
      changes.back().text += edit.line;
      continue;
    }
    at += edit.line.size();
    if (differs) changes.back().end = at;
  }
  return changes;
}

std::string line_difference(const std::string& old_name, std::string_view before, const std::string& new_name,
                            std::string_view after) {
  if (before == after) return {};
  constexpr std::size_t context = 3;
  const auto edits = shortest_edits(lines_to_compare(before), lines_to_compare(after));
  std::string result = "--- " + old_name + "\n+++ " + new_name + "\n";
  std::size_t old_line = 0;
  std::size_t new_line = 0;
  for (std::size_t i = 0; i < edits.size();) {
    // From here to the next change; what is near enough to it, and to those that follow it closely, is shown.
    auto change = i;
    while (change < edits.size() && edits[change].mark == ' ') ++change;
    if (change == edits.size()) break;
    const auto first = change - std::min(context, change - i);
    old_line += first - i;
    new_line += first - i;
    auto last = change;
    for (auto k = change; k < edits.size() && k <= last + 2 * context; ++k) {
      if (edits[k].mark != ' ') last = k;
    }
    last = std::min(last + 1 + context, edits.size());
    result += piece(edits, first, last, old_line, new_line);
    for (i = first; i < last; ++i) {
      old_line += edits[i].mark != '+';
      new_line += edits[i].mark != '-';
    }
  }
  return result;
}

}  // namespace pal
