#include <fmt/format.h>

#include <ostream>

#include "codegen/generate.hpp"
#include "pal/driver/commands.hpp"
#include "pal/support/output.hpp"

namespace pal::driver {
namespace {

/// A make rule: the generated files depend on every text that was read.
std::string depfile_text(const std::vector<OutputFile>& outputs, const SourceManager& sources) {
  std::string text;
  for (const OutputFile& file : outputs) text += (text.empty() ? "" : " ") + file.path;
  text += ":";
  for (std::size_t i = 0; i < sources.size(); ++i) text += " \\\n  " + sources.name(FileId(i));
  return text + "\n";
}

/// Exactly one of each is needed: says what to do otherwise.
template <class Things>
bool is_one(const Things& things, const char* kind, std::ostream& err) {
  if (things.size() == 1) return true;
  err << fmt::format("pal: code is generated from one {}, but {} {} given; choose one with --{}\n", kind,
                     things.empty() ? "none" : "several", things.empty() ? "is" : "are",
                     things.empty() && std::string(kind) == "environment" ? "environment FILE" : std::string(kind) +
                     (std::string(kind) == "environment" ? "-name NAME" : " NAME"));
  return false;
}

}  // namespace

ExitStatus generate(const GenerateOptions& options, const Console& console) {
  Session session;
  const bool chosen = read(options.selection, console, session);
  std::vector<codegen::GeneratedFile> generated;
  const bool one = chosen && !session.diagnostics.has_errors() &&
                   is_one(session.specification.skills, "skill", console.err) &&
                   is_one(session.specification.environments, "environment", console.err);
  if (one) {
    generated = codegen::generate(session.specification.skills.front(), session.specification.environments.front(),
                                  session.sources, session.diagnostics);
  }
  show_findings(session, console);
  if (session.diagnostics.has_errors()) return ExitStatus::wrong_specification;
  if (!one) return ExitStatus::usage;

  std::vector<OutputFile> files;
  for (codegen::GeneratedFile& file : generated) {
    files.push_back({options.output + "/" + file.name, std::move(file.text)});
  }
  if (!options.depfile.empty()) files.push_back({options.depfile, depfile_text(files, session.sources)});
  if (const auto problem = write_files(files)) {
    console.err << "pal: " << *problem << "\n";
    return ExitStatus::usage;
  }
  return ExitStatus::all_hold;
}

}  // namespace pal::driver
