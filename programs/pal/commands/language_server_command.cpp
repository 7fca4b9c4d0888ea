// pal language-server: an editor at the other end of the standard streams.
#include <fstream>
#include <iostream>

#include "language_server/server.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/reports/editor_proofs.hpp"

namespace pal::program {

ExitStatus serve_editor(const LanguageServerOptions& options, const Console& console) {
  std::ofstream log;
  if (!options.log.empty()) {
    log.open(options.log);
    if (!log) {
      console.err << "pal: cannot write '" << options.log << "'\n";
      return ExitStatus::usage;
    }
  }
  const EditorProver prover;
  const language_server::Options server{PAL_VERSION, PAL_DOCUMENTATION_URL, &prover};
  const bool shut_down =
      language_server::serve(std::cin, console.out, console.files, server, options.log.empty() ? nullptr : &log);
  return shut_down ? ExitStatus::all_hold : ExitStatus::wrong_specification;
}

}  // namespace pal::program
