#include <algorithm>
#include <ostream>
#include <string_view>

#include "pal/support/diagnostic_code.hpp"
#include "pal/support/render.hpp"
#include "pal/support/text_width.hpp"
#include "pal/support/utf8.hpp"

namespace pal {

namespace {

// Of a line longer than this only the part around the place is shown.
constexpr std::size_t excerpt_bytes = 160;
constexpr std::size_t excerpt_lead = 60;

/// The shown part of a line, cut at code points, and the place inside it.
struct Excerpt {
  std::string text;
  int caret_column = 0;
  int caret_width = 1;
};

std::size_t back_to_code_point(std::string_view line, std::size_t at) {
  while (at > 0 && at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0) == 0x80) --at;
  return at;
}

Excerpt excerpt(std::string_view line, std::size_t begin, std::size_t end) {
  begin = std::min(begin, line.size());
  end = std::clamp(end, begin, line.size());
  std::size_t first = 0;
  std::size_t last = line.size();
  if (line.size() > excerpt_bytes) {
    first = back_to_code_point(line, begin > excerpt_lead ? begin - excerpt_lead : 0);
    last = back_to_code_point(line, std::min(line.size(), first + excerpt_bytes));
    end = std::clamp(end, begin, last);
  }
  const std::string_view lead = first > 0 ? "..." : "";
  const std::string_view tail = last < line.size() ? "..." : "";
  const auto before = std::string(lead) + std::string(line.substr(first, begin - first));
  const auto through = before + std::string(line.substr(begin, end - begin));
  const auto shown = through + std::string(line.substr(end, last - end));
  const int column = width(before);
  return {printable(shown) + std::string(tail), column, std::max(1, width(through) - column)};
}

void write_place(const SourceSpan& where, const SourceManager& sources, char mark, std::ostream& out) {
  const auto [line, column] = sources.line_column(where.file, where.begin);
  const auto number = std::to_string(line);
  const std::string gutter(number.size(), ' ');
  out << gutter << "--> " << sources.name(where.file) << ':' << line << ':' << column << '\n';

  const auto text = sources.line_text(where.file, line);
  const auto start = static_cast<std::size_t>(text.data() - sources.text(where.file).data());
  if (text.empty()) return;
  const auto begin = std::max<std::size_t>(where.begin, start) - start;
  const auto end = std::max<std::size_t>(where.end, start) - start;
  const auto shown = excerpt(text, begin, end);
  out << gutter << " |\n";
  out << number << " | " << shown.text << '\n';
  out << gutter << " | " << std::string(static_cast<std::size_t>(shown.caret_column), ' ')
      << std::string(static_cast<std::size_t>(shown.caret_width), mark) << '\n';
}

void write_count(std::size_t count, std::string_view noun, std::ostream& out) {
  out << count << ' ' << noun << (count == 1 ? "" : "s");
}

void write_summary(const std::vector<Diagnostic>& findings, std::ostream& out) {
  const auto count = [&](Severity s) {
    return static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(),
                                                  [&](const Diagnostic& d) { return d.severity == s; }));
  };
  const auto errors = count(Severity::error);
  const auto warnings = count(Severity::warning);
  if (errors == 0 && warnings == 0) return;
  if (errors != 0) write_count(errors, "error", out);
  if (errors != 0 && warnings != 0) out << ", ";
  if (warnings != 0) write_count(warnings, "warning", out);
  out << '\n';
}

}  // namespace

void render_text(const std::vector<Diagnostic>& findings, const SourceManager& sources, std::ostream& out) {
  for (const auto& finding : findings) {
    out << name(finding.severity) << '[' << name(finding.code) << "]: " << printable(finding.message) << '\n';
    if (finding.where.valid()) write_place(finding.where, sources, '^', out);
    for (const auto& note : finding.notes) {
      out << "note: " << printable(note.text) << '\n';
      if (note.where.valid()) write_place(note.where, sources, '-', out);
    }
    if (!finding.hint.empty()) out << "hint: " << printable(finding.hint) << '\n';
    out << '\n';
  }
  write_summary(findings, out);
}

}  // namespace pal
