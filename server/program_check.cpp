#include "server/program_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "operations/load.hpp"

namespace pal::server {
namespace {

std::uint32_t end_of(const operations::JsonValue& value) {
  return std::max(value.end, value.where.end);
}

/// The names and numbers down to the value in which the offset lies. Texts are nested 16 deep at most.
void path_to(const operations::JsonValue& value, std::uint32_t offset, std::vector<std::string>& path) {
  for (const operations::JsonMember& member : value.members) {
    if (offset < member.where.begin || offset >= end_of(member.value)) continue;
    path.push_back(member.name);
    return path_to(member.value, offset, path);
  }
  for (std::size_t i = 0; i < value.items.size(); ++i) {
    if (offset < value.items[i].where.begin || offset >= end_of(value.items[i])) continue;
    path.push_back(std::to_string(i));
    return path_to(value.items[i], offset, path);
  }
}

/// The first error, for a client that has no room for carets; nothing if there is none.
std::optional<Refusal> first_error(const Diagnostics& diagnostics, const SourceManager& sources,
                                   const operations::Program* program) {
  if (!diagnostics.has_errors()) return std::nullopt;
  for (const Diagnostic& finding : diagnostics.sorted()) {
    if (finding.severity != Severity::error) continue;
    Refusal refusal{Refusal::Why::wrong, finding.message, finding.hint};
    if (sources.size() > 0 && finding.where.file.valid()) {
      const auto at = sources.line_column(finding.where.file, finding.where.begin);
      refusal.place.file = sources.name(finding.where.file);
      refusal.place.line = at.line;
      refusal.place.column = at.column;
      refusal.place.field = FieldFinder(sources).at(finding.where);
      const auto extent = program != nullptr ? operations::extent_of(*program, finding.where) : std::nullopt;
      if (extent) {
        refusal.place.operation = extent->operation;
        refusal.place.icon = extent->icon;
      }
    }
    return refusal;
  }
  return Refusal{Refusal::Why::wrong, "it has errors"};
}

/// One skill as an operation, so that it is checked by the same rules.
operations::Program alone(const RunSkill& command) {
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
  return {{std::move(operation)}, {}};
}

}  // namespace

std::variant<std::string, FileError> SentFiles::read(const std::string& path, std::size_t most) const {
  const auto found = files_.find(path);
  if (found == files_.end()) return FileError{"its text was not sent, and the store has none of this name"};
  if (found->second.size() > most) return FileError{"it is too large"};
  return found->second;
}

std::string FieldFinder::at(SourceSpan where) {
  if (!where.valid()) return {};
  const auto [known, fresh] = texts_.try_emplace(where.file);
  std::optional<operations::JsonValue>& json = known->second;
  Diagnostics ignored;
  if (fresh) json = operations::parse_json(sources_, where.file, ignored);
  if (!json) return {};
  std::vector<std::string> path;
  path_to(*json, where.begin, path);
  // What lies before the fields of an icon, or of an operation.
  std::size_t from = 0;
  if (path.size() > from + 1 && path[from] == "operations") from += 2;
  if (path.size() > from + 1 && path[from] == "icons") from += 2;
  path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(from));
  return fmt::format("{}", fmt::join(path, "/"));
}

std::optional<Refusal> mistake_in(const RunSkill& command, const operations::Cell& cell) {
  Diagnostics diagnostics;
  operations::check_cell(alone(command), cell, diagnostics);
  return first_error(diagnostics, {}, nullptr);
}

std::variant<operations::Program, Refusal> program_of(const LoadOperation& command,
                                                      const operations::Cell& cell,
                                                      const operations::Stop& stop) {
  const SentFiles files(command.files);
  SourceManager sources;
  Diagnostics diagnostics;
  bool whole = true;
  auto program = operations::load(files, sources, command.main, diagnostics);
  if (program && !diagnostics.has_errors()) whole = operations::check_shape(*program, diagnostics, stop);
  if (program && whole && !diagnostics.has_errors())
    whole = operations::check_cell(*program, cell, diagnostics, stop);
  if (auto mistake = first_error(diagnostics, sources, program ? &*program : nullptr))
    return std::move(*mistake);
  if (!whole) return Refusal{Refusal::Why::cancelled, "the check was cancelled"};
  if (!program)
    return Refusal{Refusal::Why::wrong, "there is no operation in it", {}, {command.main, {}, {}, {}}};
  return std::move(*program);
}

}  // namespace pal::server
