// pal operation skeleton: PAL files to begin with, of the skills that operations only plan.
#include <map>
#include <ostream>

#include "operations/load.hpp"
#include "operations/skeleton.hpp"
#include "pal/support/file_system.hpp"
#include "pal/support/output.hpp"
#include "pal/syntax/format.hpp"
#include "programs/pal/commands/operation_files.hpp"

namespace pal::program {

ExitStatus skeleton_of_operation(const OperationOptions& options, const Console& console) {
  Session session;
  session.max_errors = options.max_errors;
  std::map<std::string, std::string> skeletons;  // by name
  for (const std::string& file : options.files) {
    const auto program = operations::load(console.files, session.sources, file, session.diagnostics);
    if (!program || session.diagnostics.has_errors()) continue;
    for (const operations::Operation& operation : program->operations)
      for (const operations::Icon& icon : operation.icons) {
        if (icon.kind != operations::IconKind::planned) continue;
        const std::string name = operations::skeleton_name(icon);
        const FileId written = session.sources.add(name + ".pal", operations::skeleton_of(icon));
        // A unit that PAL does not know is found here.
        if (const auto text = syntax::format(session.sources, written, session.diagnostics))
          skeletons.emplace(name, *text);
      }
  }
  show_findings(session, console);
  if (session.diagnostics.has_errors()) return status_of_findings(session);
  if (skeletons.empty()) {
    console.err << "pal: nothing is planned there: no icon is of the kind 'planned'\n";
    return ExitStatus::wrong_specification;
  }
  std::vector<OutputFile> files;
  for (const auto& [name, text] : skeletons) {
    if (options.output.empty()) {
      console.out << text;
      continue;
    }
    const std::string path = options.output + "/" + name + ".pal";
    // What somebody may have gone on with is not lost.
    if (!std::holds_alternative<FileError>(console.files.read(path))) {
      console.err << "pal: '" << path << "' is there already; name another folder\n";
      return ExitStatus::usage;
    }
    files.push_back({path, text});
  }
  if (options.output.empty()) return ExitStatus::all_hold;
  if (const auto problem = write_files(files)) {
    console.err << "pal: " << *problem << "\n";
    return ExitStatus::usage;
  }
  for (const OutputFile& file : files) console.out << file.path << "\n";
  return ExitStatus::all_hold;
}

}  // namespace pal::program
