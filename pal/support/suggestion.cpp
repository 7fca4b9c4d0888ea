#include "pal/support/suggestion.hpp"

#include <algorithm>
#include <ostream>
#include <string>
#include <string_view>

#include "pal/support/edit.hpp"
#include "pal/support/excerpt.hpp"

namespace pal {
namespace {

/// Whole lines of one file that change together.
struct Hunk {
  FileId file{};
  int line = 0;  // the first of them
  std::size_t begin = 0, end = 0;
  std::vector<Edit> edits;
};

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    const bool dos = end > 0 && text[end - 1] == '\r';
    lines.push_back(text.substr(0, end - (dos ? 1 : 0)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::vector<Hunk> hunks_of(std::vector<Edit> edits, const SourceManager& sources) {
  std::stable_sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) {
    return a.where.file != b.where.file ? a.where.file < b.where.file : a.where.begin < b.where.begin;
  });
  std::vector<Hunk> hunks;
  for (const Edit& edit : edits) {
    const auto text = sources.text(edit.where.file);
    const auto before =
        edit.where.begin == 0 ? std::string_view::npos : text.rfind('\n', edit.where.begin - 1);
    const auto begin = before == std::string_view::npos ? 0 : before + 1;
    const auto end = std::min(text.find('\n', std::max<std::size_t>(begin, edit.where.end)), text.size());
    if (!hunks.empty() && hunks.back().file == edit.where.file && begin <= hunks.back().end) {
      hunks.back().end = std::max(hunks.back().end, end);
    } else {
      hunks.push_back({edit.where.file,
                       sources.line_column(edit.where.file, static_cast<std::uint32_t>(begin)).line,
                       begin,
                       end,
                       {}});
    }
    hunks.back().edits.push_back(edit);
  }
  return hunks;
}

std::string changed(const Hunk& hunk, std::string_view text) {
  auto edits = hunk.edits;
  for (Edit& edit : edits) {
    edit.where.begin -= static_cast<std::uint32_t>(hunk.begin);
    edit.where.end -= static_cast<std::uint32_t>(hunk.begin);
  }
  return apply(edits, hunk.file, text.substr(hunk.begin, hunk.end - hunk.begin));
}

void write_line(int number, std::size_t gutter, char sign, std::string_view line, std::size_t near,
                std::ostream& out) {
  const auto shown = std::to_string(number);
  out << shown << std::string(gutter - shown.size() + 1, ' ') << sign << ' ' << excerpt(line, near, near).text
      << '\n';
}

/// The first byte in which two lines differ.
std::size_t difference(std::string_view a, std::string_view b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

void write_hunk(const Hunk& hunk, const SourceManager& sources, std::ostream& out) {
  const auto text = sources.text(hunk.file);
  const std::string result = changed(hunk, text);
  auto old_lines = lines_of(text.substr(hunk.begin, hunk.end - hunk.begin));
  auto new_lines = lines_of(result);
  int number = hunk.line;
  while (!old_lines.empty() && !new_lines.empty() && old_lines.back() == new_lines.back()) {
    old_lines.pop_back();
    new_lines.pop_back();
  }
  std::size_t same = 0;
  while (same < old_lines.size() && same < new_lines.size() && old_lines[same] == new_lines[same]) ++same;
  number += static_cast<int>(same);
  // What only blanks are left of is as good as gone.
  std::erase_if(new_lines,
                [](std::string_view line) { return line.find_first_not_of(" \t\r") == line.npos; });
  const auto gutter =
      std::to_string(number + static_cast<int>(std::max(old_lines.size(), new_lines.size()))).size();
  out << std::string(gutter, ' ') << " |\n";
  const auto other = [&](const auto& lines, std::size_t i) {
    return i < lines.size() ? lines[i] : std::string_view();
  };
  for (std::size_t i = same; i < old_lines.size(); ++i)
    write_line(number + static_cast<int>(i - same), gutter, '-', old_lines[i],
               difference(old_lines[i], other(new_lines, i)), out);
  for (std::size_t i = same; i < new_lines.size(); ++i)
    write_line(number + static_cast<int>(i - same), gutter, '+', new_lines[i],
               difference(new_lines[i], other(old_lines, i)), out);
}

}  // namespace

void write_suggestion(const std::vector<Edit>& edits, const SourceManager& sources, std::ostream& out) {
  for (const Hunk& hunk : hunks_of(edits, sources)) write_hunk(hunk, sources, out);
}

}  // namespace pal
