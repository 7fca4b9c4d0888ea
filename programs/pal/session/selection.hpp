// What the commands have in common: the files to read, and the skill and environment that are meant.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pal/check/check.hpp"
#include "pal/support/diagnostic.hpp"
#include "pal/support/source.hpp"
#include "programs/pal/session/console.hpp"
#include "programs/pal/session/exit_status.hpp"

namespace pal::program {

/// The usual number of findings that are shown.
constexpr std::size_t default_max_errors = 100;

/// As given on the command line. Empty names choose everything.
struct Selection {
  std::vector<std::string> files;         // .pal files, with the skills in question
  std::vector<std::string> environments;  // further .pal files, of which only the environments count
  std::string skill;
  std::string environment;                      // the name of one
  std::size_t max_errors = default_max_errors;  // findings that text shows; 0: all
  std::vector<std::string> measured{};          // .pal files with measured times, to be compared
};

/// A specification with its texts and the findings about it so far.
struct Session {
  SourceManager sources;
  Diagnostics diagnostics;
  check::Specification specification;
  std::size_t max_errors = default_max_errors;
  std::function<bool()> stop;  // ends checks that take long, undecided; empty: nothing does
};

/// Reads and checks everything that `selection` names, and keeps what it chooses. Findings are left in the
/// session. A name that chooses nothing is reported to `console.err`, and the answer is false.
bool read(const Selection& selection, const Console& console, Session& session);

/// The exit status of a command that found errors: `usage` if a file of the command line could not be read,
/// else `wrong_specification`. `all_hold` if there are no errors.
ExitStatus status_of_findings(const Session& session);

/// Whether the command line names this file and it could not be read.
bool is_unread(FileId file, const Session& session);

/// Makes each warning so far an error, if all findings were kept. Whether there is any.
bool raise_warnings(Session& session);

/// Renders the findings as text to `console.err`.
void show_findings(const Session& session, const Console& console);

}  // namespace pal::program
