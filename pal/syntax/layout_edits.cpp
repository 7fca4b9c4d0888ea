// The canonical layout as edits, also of a text with errors.
#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "pal/support/line_difference.hpp"
#include "pal/syntax/format.hpp"
#include "pal/syntax/layout.hpp"
#include "pal/syntax/lines.hpp"
#include "pal/syntax/reading.hpp"

namespace pal::syntax {

namespace {

/// With their breaks.
std::vector<std::string_view> lines_with_breaks(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

bool has_no_words(std::string_view line) {
  return line.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

/// A text in which some lines are comments, so that the rest can be laid out. Afterwards they come back as
/// they were.
class LayoutAround {
 public:
  LayoutAround(FileId file, std::string_view text) : file_(file), lines_(lines_with_breaks(text)) {
    while (text.find(mark_) != std::string_view::npos) mark_ += '-';
  }

  /// Nothing: no way was found to leave out what is wrong.
  std::optional<std::string> lay_out() {
    Diagnostics wrong;
    if (auto whole = attempt({}, wrong)) return whole;
    const std::set<std::size_t> lines = lines_of_findings(wrong);
    if (auto rest = attempt(lines, wrong)) return rest;
    return attempt(whole_units(lines), wrong);
  }

 private:
  std::optional<std::string> attempt(const std::set<std::size_t>& left_out, Diagnostics& diagnostics) const {
    std::string text;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      text += left_out.contains(i) ? mark_ + std::to_string(i) + "\n" : std::string(lines_[i]);
    const Reading reading(file_, text, diagnostics);
    if (!reading.complete()) return std::nullopt;
    return with_lines_back(syntax::lay_out(syntax::lines_of(reading, text)));
  }

  std::string with_lines_back(const std::string& text) const {
    std::string result;
    for (const std::string_view line : lines_with_breaks(text)) {
      const auto at = line.find(mark_);
      if (at == std::string_view::npos) {
        result += line;
      } else {
        result += lines_[std::stoul(std::string(line.substr(at + mark_.size())))];
      }
    }
    return result;
  }

  /// A line with nothing on it can be left as it is.
  std::set<std::size_t> lines_of_findings(const Diagnostics& diagnostics) const {
    std::set<std::size_t> found;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const std::size_t end = begin + lines_[i].size();
      for (const Diagnostic& finding : diagnostics.all()) {
        if (finding.where.begin < end && finding.where.end >= begin && !has_no_words(lines_[i]))
          found.insert(i);
      }
      begin = end;
    }
    return found;
  }

  /// The units in which those lines stand. A unit begins at the left.
  std::set<std::size_t> whole_units(const std::set<std::size_t>& lines) const {
    static const std::set<std::string_view> inner{"BEGIN", "END", "begin", "end"};
    const auto begins = [&](std::size_t i) {
      const std::string_view line = lines_[i];
      const auto word = line.substr(0, line.find_first_of(" \t\r\n"));
      return !word.empty() && word.front() != '#' && !inner.contains(word);
    };
    std::set<std::size_t> units;
    for (const std::size_t line : lines) {
      std::size_t first = line;
      while (first > 0 && !begins(first)) --first;
      std::size_t end = line + 1;
      while (end < lines_.size() && !begins(end)) ++end;
      for (std::size_t i = first; i < end; ++i) {
        if (!has_no_words(lines_[i])) units.insert(i);
      }
    }
    return units;
  }

  FileId file_;
  std::vector<std::string_view> lines_;
  std::string mark_ = "# left out ";
};

}  // namespace

std::vector<Edit> layout_edits(const SourceManager& sources, FileId file, const SourceSpan& within) {
  const std::string_view text = sources.text(file);
  const auto laid_out = LayoutAround(file, text).lay_out();
  std::vector<Edit> edits;
  if (!laid_out) return edits;
  for (LineChange& change : line_changes(text, *laid_out)) {
    const auto begin = static_cast<std::uint32_t>(change.begin);
    const auto end = static_cast<std::uint32_t>(change.end);
    if (begin > within.end || (end <= within.begin && begin < within.begin)) continue;
    edits.push_back({{file, begin, end}, std::move(change.text)});
  }
  return edits;
}

}  // namespace pal::syntax
