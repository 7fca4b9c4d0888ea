// pal operation storyboard: an execution as a picture.
#include <ostream>

#include "operations/load.hpp"
#include "operations/parse.hpp"
#include "operations/read_log.hpp"
#include "operations/storyboard.hpp"
#include "operations/write.hpp"
#include "programs/pal/commands/operation_files.hpp"
#include "programs/pal/session/write.hpp"

namespace pal::program {

ExitStatus tell_operation(const OperationOptions& options, const Console& console) {
  const bool html = options.output.ends_with(".html");
  if (!html && !options.output.empty() && !options.output.ends_with(".md")) {
    console.err << "pal: '" << options.output << "' is neither .html nor .md\n";
    return ExitStatus::usage;
  }
  if (options.files.size() != 1) {
    console.err << "pal: a storyboard is of one operation; give one file\n";
    return ExitStatus::usage;
  }
  Session session;
  session.max_errors = options.max_errors;
  const auto program =
      operations::load(console.files, session.sources, options.files.front(), session.diagnostics);
  operations::Skills skills;
  std::vector<operations::Step> steps;
  if (program && !session.diagnostics.has_errors()) {
    operations::check_shape(*program, session.diagnostics);
    if (!options.skills.empty())
      skills = read_skills(options, operations::skills_of(*program), console, session, BuiltSkills(console.files));
    if (!options.run.empty()) {
      auto content = console.files.read(options.run);
      if (const auto* error = std::get_if<FileError>(&content)) {
        console.err << "pal: cannot read '" << options.run << "': " << error->reason << "\n";
        return ExitStatus::usage;
      }
      const FileId log = session.sources.add(options.run, std::get<std::string>(content));
      if (!session.diagnostics.has_errors())
        steps = operations::read_log(session.sources, log, *program, session.diagnostics);
    }
  }
  show_findings(session, console);
  if (!program || session.diagnostics.has_errors()) return status_of_findings(session);
  std::optional<operations::Happened> run;
  if (!options.run.empty()) run.emplace(*program, steps);
  const operations::Happened* happened = run ? &*run : nullptr;
  const std::string document = html ? operations::storyboard_html(*program, skills, happened)
                                    : operations::storyboard_markdown(*program, skills, happened);
  if (options.output.empty()) {
    console.out << document;
    return ExitStatus::all_hold;
  }
  return write_and_list({{options.output, document}}, inputs_of(session), console);
}

ExitStatus format_operation(const OperationOptions& options, const Console& console) {
  std::vector<OutputFile> changed;
  Session session;
  for (const std::string& path : options.files) {
    auto content = console.files.read(path);
    if (const auto* error = std::get_if<FileError>(&content)) {
      console.err << "pal: cannot read '" << path << "': " << error->reason << "\n";
      return ExitStatus::usage;
    }
    const std::string& text = std::get<std::string>(content);
    const auto document =
        operations::parse(session.sources, session.sources.add(path, text), session.diagnostics);
    if (!document || session.diagnostics.has_errors()) continue;
    std::string written = operations::write(*document);
    if (written != text) changed.push_back({path, std::move(written)});
  }
  show_findings(session, console);
  if (session.diagnostics.has_errors()) return status_of_findings(session);
  if (!options.check) {
    if (const auto problem = write_files(changed)) {
      console.err << "pal: " << *problem << "\n";
      return ExitStatus::usage;
    }
  }
  for (const OutputFile& file : changed) console.out << file.path << "\n";
  return options.check && !changed.empty() ? ExitStatus::wrong_specification : ExitStatus::all_hold;
}

}  // namespace pal::program
