// pal language-server: an editor at the other end of the standard streams.
#include <fstream>
#include <iostream>

#include "language_server/server.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/reports/editor_proofs.hpp"
#include "programs/pal/session/memory.hpp"

namespace pal::program {
namespace {

/// So much freed memory is kept: the next text needs it. Beside it are the pages of the program itself.
constexpr std::size_t soon_used_again = 40u << 20;

}  // namespace

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
  language_server::Options server{PAL_VERSION, PAL_DOCUMENTATION_URL, &prover};
  server.at_rest = [] { give_back_memory_beyond(soon_used_again); };
  const bool shut_down = language_server::serve(std::cin, console.out, console.files, server,
                                                options.log.empty() ? nullptr : &log);
  return shut_down ? ExitStatus::all_hold : ExitStatus::wrong_specification;
}

}  // namespace pal::program
