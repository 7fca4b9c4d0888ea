#include <fmt/format.h>

#include <ostream>
#include <sstream>
#include <stdexcept>

#include "pal/driver/commands.hpp"
#include "pal/driver/witness.hpp"

namespace pal::driver {

ExitStatus replay(const ReplayOptions& options, const Console& console) {
  const auto content = console.files.read(options.witness);
  if (const auto* error = std::get_if<FileError>(&content)) {
    console.err << fmt::format("pal: cannot read '{}': {}\n", options.witness, error->reason);
    return ExitStatus::usage;
  }
  std::vector<analyzer::rules::FiledWitness> witnesses;
  try {
    std::istringstream in(std::get<std::string>(content));
    witnesses = analyzer::rules::read_witnesses(in);
  } catch (const std::runtime_error& error) {
    console.err << fmt::format("pal: cannot replay '{}': {}\n", options.witness, error.what());
    return ExitStatus::usage;
  }
  Session session;
  if (!read(options.selection, console, session)) return ExitStatus::usage;
  show_findings(session, console);
  if (session.diagnostics.has_errors()) return status_of_findings(session);
  return confirm(witnesses, session, console.out) ? ExitStatus::all_hold : ExitStatus::not_met;
}

}  // namespace pal::driver
