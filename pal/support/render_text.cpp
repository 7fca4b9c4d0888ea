// Findings as text, with the line of the source and a caret.
#include <algorithm>
#include <ostream>
#include <string_view>

#include "pal/support/diagnostic_code.hpp"
#include "pal/support/excerpt.hpp"
#include "pal/support/render.hpp"
#include "pal/support/suggestion.hpp"
#include "pal/support/text_width.hpp"

namespace pal {

namespace {

void write_marked(const std::string& number, const std::string& gutter, std::string_view line,
                  std::size_t begin, std::size_t end, char mark, std::ostream& out) {
  const auto shown = excerpt(line, begin, end);
  out << number << gutter.substr(number.size()) << " | " << shown.text << '\n';
  out << gutter << " | " << std::string(static_cast<std::size_t>(shown.caret_column), ' ')
      << std::string(static_cast<std::size_t>(shown.caret_width), mark) << '\n';
}

/// The line on which a place of several lines ends, marked from its first word.
void write_last_line(const SourceSpan& where, int line, const std::string& gutter,
                     const SourceManager& sources, char mark, std::ostream& out) {
  const auto text = sources.line_text(where.file, line);
  const auto start = static_cast<std::size_t>(text.data() - sources.text(where.file).data());
  const auto first_word = std::min(text.find_first_not_of(" \t"), text.size());
  if (line > sources.line_column(where.file, where.begin).line + 1) out << gutter << "...\n";
  write_marked(std::to_string(line), gutter, text, first_word, where.end - start, mark, out);
}

void write_place(const SourceSpan& where, const SourceManager& sources, char mark, std::ostream& out) {
  const auto [line, column] = sources.line_column(where.file, where.begin);
  const auto number = std::to_string(line);
  const auto last_byte = where.end > where.begin ? where.end - 1 : where.begin;
  const int last = sources.line_column(where.file, last_byte).line;
  const std::string gutter(std::to_string(last).size(), ' ');
  out << gutter << "--> " << printable(sources.name(where.file)) << ':' << line << ':' << column << '\n';

  const auto text = sources.line_text(where.file, line);
  const auto start = static_cast<std::size_t>(text.data() - sources.text(where.file).data());
  if (text.empty()) return;
  const auto begin = std::max<std::size_t>(where.begin, start) - start;
  const auto end = std::max<std::size_t>(where.end, start) - start;
  out << gutter << " |\n";
  write_marked(number, gutter, text, begin, end, mark, out);
  if (last > line) write_last_line(where, last, gutter, sources, mark, out);
}

void write_count(std::size_t count, std::string_view noun, std::ostream& out) {
  out << count << ' ' << noun << (count == 1 ? "" : "s");
}

FindingCounts counts_of(const std::vector<Diagnostic>& findings) {
  FindingCounts counts;
  for (const auto& finding : findings) {
    if (finding.severity != Severity::note) ++counts.of(finding.severity);  // a note is nothing wrong
  }
  return counts;
}

/// How many of each severity are shown: no warning takes the place of an error.
FindingCounts shown(const FindingCounts& found, std::size_t most) {
  if (most == 0) return found;
  const auto errors = std::min(found.errors, most);
  return {errors, std::min(found.warnings, most - errors)};
}

/// Whether the notes tell what adds up to a figure: many, of which the first says most.
bool is_story(const Diagnostic& finding) {
  return finding.code == Code::PAL0890 || finding.code == Code::PAL0891;
}

/// `brief`: with its place in the same line.
void write_note(const Note& note, bool brief, const SourceManager& sources, std::ostream& out) {
  out << "note: " << printable(note.text);
  if (note.where.valid() && brief)
    out << " (" << printable(sources.name(note.where.file)) << ':'
        << sources.line_column(note.where.file, note.where.begin).line << ')';
  out << '\n';
  if (note.where.valid() && !brief) write_place(note.where, sources, '-', out);
}

void write_finding(const Diagnostic& finding, const SourceManager& sources, std::ostream& out) {
  out << name(finding.severity) << '[' << name(finding.code) << "]: " << printable(finding.message) << '\n';
  if (finding.where.valid()) write_place(finding.where, sources, '^', out);
  for (const auto& note : finding.notes)
    write_note(note, &note != &finding.notes.front() && is_story(finding), sources, out);
  if (!finding.hint.empty()) out << "hint: " << printable(finding.hint) << '\n';
  write_suggestion(finding.fix, sources, out);
  out << '\n';
}

void write_rest(std::size_t left_out, const TextLimit& limit, std::ostream& out) {
  const auto more = left_out + limit.not_kept.sum();
  if (more == 0) return;
  out << "\u2026 and " << more << " more";
  if (left_out != 0) out << "; --max-errors 0 shows " << (limit.not_kept.sum() == 0 ? "all" : "more");
  if (limit.not_kept.sum() != 0) {
    out << "; only the first " << Diagnostics::most_kept << " errors and as many warnings are kept";
  }
  out << "\n\n";
}

void write_summary(const FindingCounts& counts, std::ostream& out) {
  if (counts.sum() == 0) return;
  if (counts.errors != 0) write_count(counts.errors, "error", out);
  if (counts.errors != 0 && counts.warnings != 0) out << ", ";
  if (counts.warnings != 0) write_count(counts.warnings, "warning", out);
  out << '\n';
}

}  // namespace

void render_text(const std::vector<Diagnostic>& findings, const SourceManager& sources, std::ostream& out,
                 const TextLimit& limit) {
  const auto found = counts_of(findings);
  const auto show = shown(found, limit.most);
  auto left = show;
  for (const auto& finding : findings) {
    if (finding.severity != Severity::note) {
      if (left.of(finding.severity) == 0) continue;
      --left.of(finding.severity);
    }
    write_finding(finding, sources, out);
  }
  write_rest(found.sum() - show.sum(), limit, out);
  write_summary({found.errors + limit.not_kept.errors, found.warnings + limit.not_kept.warnings}, out);
}

}  // namespace pal
