// Colours of a report on a terminal.
#pragma once

#include <string>

namespace pal::program {

/// Whether a stream gets colours: never if NO_COLOR is set to anything, else always if CLICOLOR_FORCE is set
/// to anything but 0, else if the stream is a terminal whose TERM is not "dumb" (https://no-color.org,
/// https://bixense.com/clicolors).
bool wants_colour(bool is_terminal);

/// A report of findings, as render_text writes it, with colours.
std::string coloured_findings(const std::string& text);

/// A table of verdicts, as write_table writes it, with colours.
std::string coloured_table(const std::string& text);

/// A page in Markdown as a terminal shows it: without its marks, in lines of at most `width` columns. With
/// `colour`, headings are bold and code has a colour.
std::string terminal_page(const std::string& markdown, bool colour, std::size_t width = 80);

}  // namespace pal::program
