// pal generate: C++ of a skill that is right and meets its requirements.
#include <fmt/format.h>

#include <ostream>

#include "codegen/explain.hpp"
#include "codegen/generate.hpp"
#include "operations/declared.hpp"
#include "pal/check/resources.hpp"
#include "pal/check/shared_uses.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/session/interruption.hpp"
#include "programs/pal/session/proof.hpp"
#include "programs/pal/session/write.hpp"

namespace pal::program {
namespace {

/// `path` as make rules spell it.
std::string for_make(const std::string& path) {
  std::string text;
  for (const char c : path) {
    if (c == ' ' || c == '#') text += '\\';
    if (c == '$') text += '$';
    text += c;
  }
  return text;
}

/// A make rule: the target, or else the generated files, depend on every text that was read.
std::string depfile_text(const std::vector<OutputFile>& outputs, const GenerateOptions& options,
                         const SourceManager& sources) {
  std::string text = for_make(options.depfile_target);
  for (const OutputFile& file : outputs) {
    if (options.depfile_target.empty()) text += (text.empty() ? "" : " ") + for_make(file.path);
  }
  text += ":";
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::string& name = sources.name(FileId(i));
    const bool relative = !options.depfile_folder.empty() && !name.starts_with('/');
    text += " \\\n  " + for_make(relative ? options.depfile_folder + "/" + name : name);
  }
  return text + "\n";
}

/// Exactly one of each is needed: says what to do otherwise.
bool is_one(std::size_t count, const char* kind, const char* none, const char* several, std::ostream& err) {
  if (count == 1) return true;
  err << fmt::format("pal: code is generated from one {}, but there {}; {}\n", kind,
                     count == 0 ? "is none" : "are several", count == 0 ? none : several);
  return false;
}

/// Reads what the skill declares, and adds it to the session's texts. Invalid: it is wrong, or cannot be
/// read, and `status` says which.
FileId read_declared(const std::string& path, const Console& console, Session& session, ExitStatus& status) {
  auto read = console.files.read(path);
  if (const auto* error = std::get_if<FileError>(&read)) {
    console.err << fmt::format("pal: cannot read '{}': {}\n", path, error->reason);
    status = ExitStatus::usage;
    return {};
  }
  const std::string& text = std::get<std::string>(read);
  auto declared = operations::read_declared(text);
  std::optional<operations::DeclaredError> wrong;
  if (const auto* error = std::get_if<operations::DeclaredError>(&declared))
    wrong = *error;
  else
    wrong = operations::misfit(std::get<operations::Declared>(declared),
                               session.specification.skills.front().skill);
  if (wrong) {
    console.err << fmt::format("pal: {}:{}: {}\n", path, wrong->line, wrong->cause);
    status = ExitStatus::wrong_specification;
    return {};
  }
  return session.sources.add(path, text);
}

}  // namespace

ExitStatus generate(const GenerateOptions& options, const Console& console) {
  Session session;
  const Interruption interruption;  // till all is written
  limit_checks(options.limits, session);
  const bool chosen = read(options.selection, console, session);
  std::vector<codegen::GeneratedFile> generated;
  const bool one =
      chosen && !session.diagnostics.has_errors() &&
      is_one(session.specification.skills.size(), "skill", "give a file with a SKILL",
             "choose with --skill NAME", console.err) &&
      is_one(session.specification.environments.size(), "environment", "give one with --environment FILE",
             "choose with --environment-name NAME", console.err);
  if (one) {
    check::check_listed(session.specification.skills.front(), session.specification.environments.front(),
                        session.diagnostics);
    check::check_shared_uses(session.specification.skills.front(), session.specification.environments.front(),
                             session.diagnostics);
    const auto plan =
        codegen::make_plan(session.specification.skills.front(), session.specification.environments.front(),
                           session.sources, session.diagnostics);
    if (plan && options.explain && !session.diagnostics.has_errors()) {
      codegen::explain(*plan, console.out);
      show_findings(session, console);
      return status_of_findings(session);
    }
    if (plan) generated = codegen::emit(*plan, {.debug_lines = options.debug_lines});
    FileId declared;
    if (plan && !options.declared.empty()) {
      ExitStatus status = ExitStatus::all_hold;
      declared = read_declared(options.declared, console, session, status);
      if (!declared.valid()) {
        show_findings(session, console);
        return status;
      }
    }
    if (plan && options.plugin) generated.push_back(codegen::emit_plugin(*plan, session.sources, declared));
  }
  if (one && !options.allow_failing && !session.diagnostics.has_errors()) {
    const std::vector<Proof> proofs = prove(session, options.limits);
    if (!session.diagnostics.has_errors() && !all_hold(proofs)) {
      report_unmet(proofs, false, session);
      show_findings(session, console);
      console.err << "pal: nothing was generated, since a requirement does not hold; --allow-failing "
                     "generates all the same\n";
      return ExitStatus::not_met;
    }
  }
  show_findings(session, console);
  if (session.diagnostics.has_errors()) return status_of_findings(session);
  if (!one) return ExitStatus::usage;

  std::vector<OutputFile> files;
  for (codegen::GeneratedFile& file : generated) {
    files.push_back({options.output + "/" + file.name, std::move(file.text)});
  }
  if (!options.depfile.empty())
    files.push_back({options.depfile, depfile_text(files, options, session.sources)});
  return write_and_list(files, inputs_of(session), console);
}

}  // namespace pal::program
