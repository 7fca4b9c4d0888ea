#include "programs/pal/reports/check_display.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <ostream>
#include <string_view>

#include "pal/support/text_width.hpp"
#include "pal/support/utf8.hpp"
#include "programs/pal/reports/check_report.hpp"

namespace pal::program {
namespace {

using State = analyzer::VerdictState;

constexpr std::size_t bar_width = 30;

/// As much of a line as fits, so that it takes one line of the terminal.
std::string cut(const std::string& line, std::size_t columns) {
  std::string made;
  std::string_view rest = line;
  int column = 0;
  while (!rest.empty()) {
    const auto next = utf8::decode(rest);
    column += width(next.code_point);
    if (column > static_cast<int>(columns)) break;
    made += rest.substr(0, next.bytes);
    rest.remove_prefix(next.bytes);
  }
  return made;
}

std::string bar(const analyzer::Analysis& known) {
  const std::size_t all = known.verdicts.size();
  const auto decided = static_cast<std::size_t>(
      std::count_if(known.verdicts.begin(), known.verdicts.end(),
                    [](const analyzer::Verdict& verdict) { return verdict.state != State::undecided; }));
  const std::size_t filled = all == 0 ? bar_width : bar_width * decided / all;
  return "  [" + std::string(filled, '#') + std::string(bar_width - filled, '.') + "] " +
         std::to_string(decided) + " of " + std::to_string(all) +
         " requirements decided; Ctrl-C ends the search and keeps what is known";
}

}  // namespace

TerminalSize terminal_size() {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_row == 0 || size.ws_col == 0) return {};
  return {size.ws_row, size.ws_col};
}

CheckDisplay::CheckDisplay(std::ostream& out, TerminalSize size, std::chrono::milliseconds patience)
    : out_(out), size_(size), begin_(std::chrono::steady_clock::now() + patience) {}

CheckDisplay::~CheckDisplay() {
  clear();
}

void CheckDisplay::show(const analyzer::Problem& problem, const analyzer::Analysis& known) {
  if (std::chrono::steady_clock::now() < begin_) return;
  std::vector<std::string> lines{problem.skill + " in " + problem.environment};
  const std::vector<std::string> rows = table_rows(problem, known, true);
  // More than a screen could not be taken back.
  const std::size_t room = size_.lines > 4 ? size_.lines - 4 : 1;
  lines.insert(lines.end(), rows.begin(),
               rows.begin() + static_cast<std::ptrdiff_t>(std::min(rows.size(), room)));
  if (rows.size() > room) lines.push_back("  … " + std::to_string(rows.size() - room) + " more");
  lines.push_back(bar(known));
  for (std::string& line : lines) line = cut(line, size_.columns - 1);
  if (lines == shown_) return;
  clear();
  for (const std::string& line : lines) out_ << line << "\n";
  out_ << std::flush;
  shown_ = std::move(lines);
}

void CheckDisplay::clear() {
  if (!shown_.empty()) out_ << "\x1b[" << shown_.size() << "A\r\x1b[J" << std::flush;
  shown_.clear();
}

}  // namespace pal::program
