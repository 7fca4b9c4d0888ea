// What each command does, or why it is refused. All is called with the lock of the desk held.
#include <fmt/format.h>

#include "operations/load.hpp"
#include "pal/support/file_system.hpp"
#include "runtime_system/private/desk_parts.hpp"

namespace pal::runtime_system {
namespace {

using operations::ExecutionState;

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

void Desk::Parts::start_again() {
  for (const operations::Icon& icon : executor->program().operations.front().icons)
    if (icon.kind == operations::IconKind::start) return executor->start_from(icon.id);
}

void Desk::Parts::begin(Activity activity) {
  status.activity = activity;
  accepted_stops = stops;
  accepted_pauses = pauses;
  changed.notify_all();
}

}  // namespace pal::runtime_system
