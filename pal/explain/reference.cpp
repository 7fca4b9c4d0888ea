#include "pal/explain/reference.hpp"

#include <iomanip>
#include <ostream>
#include <set>
#include <string>
#include <string_view>

#include "pal/explain/codes.hpp"
#include "pal/explain/page.hpp"
#include "pal/support/finding.hpp"

namespace pal::explain {
namespace {

constexpr std::string_view introduction =
    "# Findings\n"
    "\n"
    "What `pal check` and the other commands find wrong, by code. A code keeps its meaning for ever; `pal "
    "explain CODE` prints\n"
    "its page. Every example gives the finding and every cure removes it: a test runs `pal check` on all of "
    "them.\n"
    "\n"
    "This document is written by `pal explain --all > docs/reference/diagnostics.md` from the table in\n"
    "[pal/support/findings](../../pal/support/findings) and the pages in "
    "[pal/explain/pages](../../pal/explain/pages).\n"
    "\n";

}  // namespace

void write_list(std::ostream& out) {
  for (const Code code : all_codes())
    out << name(code) << "  " << std::left << std::setw(7) << name(severity(code)) << "  " << title(code)
        << "\n";
}

void write_page(Code code, std::ostream& out) {
  out << "## " << name(code) << "\n\n**" << name(severity(code)) << ": " << title(code) << "**\n\n"
      << explain(code).markdown << "\n### Texts\n\n";
  std::set<std::string_view> told;
  for (const FindingRow& row : finding_rows) {
    if (row.code == code && told.insert(row.text).second) out << "- `" << row.text << "`\n";
  }
}

void write_reference(std::ostream& out) {
  out << introduction << "| code | severity | finding |\n| --- | --- | --- |\n";
  for (const Code code : all_codes()) {
    std::string anchor(name(code));
    for (char& c : anchor) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c);
    out << "| [" << name(code) << "](#" << anchor << ") | " << name(severity(code)) << " | " << title(code)
        << " |\n";
  }
  for (const Code code : all_codes()) {
    out << "\n";
    write_page(code, out);
  }
}

}  // namespace pal::explain
