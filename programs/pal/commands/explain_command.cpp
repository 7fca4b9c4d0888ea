// pal explain: the page of a finding.
#include <ostream>
#include <sstream>

#include "pal/explain/codes.hpp"
#include "pal/explain/reference.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/session/colour.hpp"

namespace pal::program {
namespace {

void say_what_is_near(const std::string& text, std::ostream& err) {
  err << "pal: no finding has the code '" << text << "'\n";
  const auto near = explain::codes_near(text);
  if (near.empty()) {
    err << "hint: pal explain --list shows all codes\n";
    return;
  }
  err << "hint: similar ones of pal explain --list:\n";
  for (const Code code : near) err << "  " << name(code) << "  " << title(code) << "\n";
}

}  // namespace

ExitStatus explain_code(const ExplainOptions& options, const Console& console) {
  if (options.list) {
    explain::write_list(console.out);
    return ExitStatus::all_hold;
  }
  if (options.all) {
    explain::write_reference(console.out);
    return ExitStatus::all_hold;
  }
  if (options.codes.empty()) {
    console.err << "pal: explain needs a code, as in: pal explain PAL0101\nhint: pal explain --list shows "
                   "all codes\n";
    return ExitStatus::usage;
  }
  // All or none: a page would hide what is said of a wrong code after it.
  for (const std::string& text : options.codes) {
    if (explain::find_code(text)) continue;
    say_what_is_near(text, console.err);
    return ExitStatus::usage;
  }
  for (const std::string& text : options.codes) {
    if (&text != &options.codes.front()) console.out << "\n";
    std::ostringstream page;
    explain::write_page(*explain::find_code(text), page);
    console.out << (console.terminal || console.colour_out ? terminal_page(page.str(), console.colour_out)
                                                           : page.str());
  }
  return ExitStatus::all_hold;
}

}  // namespace pal::program
