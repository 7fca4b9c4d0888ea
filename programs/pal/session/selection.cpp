#include "programs/pal/session/selection.hpp"

#include <algorithm>
#include <ostream>
#include <sstream>
#include <utility>

#include "pal/check/measured.hpp"
#include "pal/check/read_sources.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "pal/support/render.hpp"
#include "programs/pal/session/colour.hpp"

namespace pal::program {
namespace {

const std::string& name_of(const pan::Network& network) {
  return network.skill.name;
}
const std::string& name_of(const pan::Environment& environment) {
  return environment.name;
}

/// Keeps what is called `name`; false, with a message, if nothing is.
template <class Thing>
bool choose(std::vector<Thing>& things, const std::string& name, const char* kind, std::ostream& err) {
  if (name.empty()) return true;
  std::vector<std::string> names;
  for (const Thing& thing : things) names.push_back(name_of(thing));
  std::erase_if(things, [&](const Thing& thing) { return name_of(thing) != name; });
  if (!things.empty()) return true;
  err << "pal: no " << kind << " is called '" << name << "' in the files given";
  if (names.empty()) {
    err << "; there is none at all\n";
    return false;
  }
  err << "; there is";
  for (const std::string& each : names) err << (&each == &names.front() ? " '" : ", '") << each << "'";
  err << "\n";
  return false;
}

/// A file; all PAL files of a folder and those below it; or for "-" the standard input.
void add_files(const std::string& path, const Console& console, std::vector<std::string>& paths) {
  if (path == "-") {
    paths.emplace_back("/dev/stdin");
  } else if (const auto below = console.files.list(path, ".pal"); below && !below->empty()) {
    paths.insert(paths.end(), below->begin(), below->end());
  } else {
    paths.push_back(path);
  }
}

/// Measured times are no part of the specification. False, with a message, if the files have none.
bool compare_measured(const std::vector<std::string>& paths, const Console& console, Session& session) {
  if (paths.empty()) return true;
  const check::Specification measured = check::check(
      check::read_sources(console.files, session.sources, paths, session.diagnostics), session.diagnostics);
  check::check_measured(session.specification.skills, session.specification.environments,
                        measured.environments, session.diagnostics);
  if (!measured.environments.empty() || session.diagnostics.has_errors()) return true;
  console.err << "pal: the files of --measured have no ENVIRONMENT; workcell run --measure writes one\n";
  return false;
}

}  // namespace

bool read(const Selection& selection, const Console& console, Session& session) {
  session.max_errors = selection.max_errors;
  std::vector<std::string> paths;
  for (const std::vector<std::string>* given : {&selection.files, &selection.environments}) {
    for (const std::string& path : *given) add_files(path, console, paths);
  }
  const std::vector<syntax::Tree> trees =
      check::read_sources(console.files, session.sources, paths, session.diagnostics);
  session.specification = check::check(trees, session.diagnostics, session.stop);

  if (session.diagnostics.has_errors()) return true;
  return choose(session.specification.skills, selection.skill, "skill", console.err) &&
         choose(session.specification.environments, selection.environment, "environment", console.err) &&
         compare_measured(selection.measured, console, session);
}

bool is_unread(FileId file, const Session& session) {
  // A file that another one uses is reported there; one that the command line names, at its own beginning.
  const auto& all = session.diagnostics.all();
  return session.sources.text(file).empty() &&
         std::any_of(all.begin(), all.end(), [&](const Diagnostic& finding) {
           return finding.code == Code::PAL0111 && finding.where.valid() && finding.where.file == file;
         });
}

bool raise_warnings(Session& session) {
  Diagnostics raised;
  bool any = session.diagnostics.not_kept().warnings != 0;
  for (const Diagnostic& finding : session.diagnostics.all()) {
    Diagnostic& again = raised.report(finding);
    if (again.severity != Severity::warning) continue;
    again.severity = Severity::error;
    any = true;
  }
  if (session.diagnostics.not_kept().sum() == 0) session.diagnostics = std::move(raised);
  return any;
}

ExitStatus status_of_findings(const Session& session) {
  if (!session.diagnostics.has_errors()) return ExitStatus::all_hold;
  bool unreadable = false;
  for (std::size_t file = 0; file < session.sources.size(); ++file)
    unreadable = unreadable || is_unread(FileId(file), session);
  return unreadable ? ExitStatus::usage : ExitStatus::wrong_specification;
}

void show_findings(const Session& session, const Console& console) {
  // The stream may be one that writes each piece at once.
  std::ostringstream text;
  render_text(session.diagnostics.sorted(), session.sources, text,
              {session.max_errors, session.diagnostics.not_kept()});
  console.err << (console.colour_err ? coloured_findings(text.str()) : text.str());
}

}  // namespace pal::program
