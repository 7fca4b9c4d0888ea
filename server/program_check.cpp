#include "server/program_check.hpp"

#include <fmt/format.h>

#include <utility>

#include "operations/load.hpp"
#include "pal/support/file_system.hpp"

namespace pal::server {
namespace {

/// The first error, for a client that has no room for carets; nothing if there is none.
std::optional<std::string> first_error(const Diagnostics& diagnostics, const SourceManager& sources) {
  if (!diagnostics.has_errors()) return std::nullopt;
  for (const Diagnostic& finding : diagnostics.sorted()) {
    if (finding.severity != Severity::error) continue;
    std::string place;
    if (sources.size() > 0 && finding.where.file.valid()) {
      const auto at = sources.line_column(finding.where.file, finding.where.begin);
      place = fmt::format("{}:{}:{}: ", sources.name(finding.where.file), at.line, at.column);
    }
    return fmt::format("{}{}{}", place, finding.message, finding.hint.empty() ? "" : "; " + finding.hint);
  }
  return "it has errors";
}

/// One skill as an operation, so that it is checked by the same rules.
operations::Program program_of(const RunSkill& command) {
  operations::Icon start, skill, end;
  start.id = "start";
  start.kind = operations::IconKind::start;
  start.next.icon = "skill";
  skill.id = "skill";
  skill.kind = operations::IconKind::skill;
  skill.skill = command.skill;
  skill.parameters = command.parameters;
  skill.next.icon = skill.error.icon = "end";
  end.id = "end";
  end.kind = operations::IconKind::exit;
  operations::Operation operation;
  operation.name = command.skill;
  operation.icons = {std::move(start), std::move(skill), std::move(end)};
  return {{std::move(operation)}};
}

}  // namespace

std::optional<std::string> mistake_in(const RunSkill& command, const ProgramRules& rules) {
  Diagnostics diagnostics;
  operations::check_skills(program_of(command), rules.skills, rules.locations, diagnostics);
  return first_error(diagnostics, {});
}

std::variant<operations::Program, std::string> load(LoadOperation command, const ProgramRules& rules) {
  const MemoryFileSystem files(std::move(command.files));
  SourceManager sources;
  Diagnostics diagnostics;
  auto program = operations::load(files, sources, command.main, diagnostics);
  if (program && !diagnostics.has_errors()) operations::check_shape(*program, diagnostics);
  if (program && !diagnostics.has_errors())
    operations::check_skills(*program, rules.skills, rules.locations, diagnostics);
  if (program && !diagnostics.has_errors()) operations::check_sensors(*program, rules.sensors, diagnostics);
  if (auto mistake = first_error(diagnostics, sources)) return std::move(*mistake);
  if (!program) return "there is no operation in it";
  return std::move(*program);
}

}  // namespace pal::server
