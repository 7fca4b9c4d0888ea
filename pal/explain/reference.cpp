#include "pal/explain/reference.hpp"

#include <iomanip>
#include <ostream>
#include <string>
#include <string_view>

#include "pal/explain/codes.hpp"
#include "pal/explain/page.hpp"

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
    "[diagnostic_code.def](../../pal/support/diagnostic_code.def) and the pages in "
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
      << explain(code).markdown;
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
