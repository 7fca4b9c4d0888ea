// pal replay: witnesses confirmed without the analysis.
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/reports/witness.hpp"

namespace pal::program {

ExitStatus replay(const ReplayOptions& options, const Console& console) {
  const auto witnesses = read_witness_file(options.witness, console);
  if (!witnesses) return ExitStatus::usage;
  Session session;
  if (!read(options.selection, console, session)) return ExitStatus::usage;
  show_findings(session, console);
  if (session.diagnostics.has_errors()) return status_of_findings(session);
  return confirm(*witnesses, session, console.out) ? ExitStatus::all_hold : ExitStatus::not_met;
}

}  // namespace pal::program
