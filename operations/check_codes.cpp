#include "operations/check_codes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "operations/cure.hpp"
#include "pal/support/finding.hpp"

namespace pal::operations {
namespace {

std::string completion_text(const Skills& skills, const Icon& icon, int code) {
  if (icon.kind == IconKind::planned)
    for (const Way& each : icon.ways)
      if (each.codes.front() == code) return fmt::format(": \"{}\"", each.text);
  const auto skill = skills.find(icon.skill);
  if (skill == skills.end()) return {};
  for (const pan::Completion& completion : skill->second.completions)
    if (completion.code == code && !completion.description.empty())
      return fmt::format(": \"{}\"", completion.description);
  return {};
}

/// Whether a CASE behind the icon, which tells codes apart by its ways alone, should have had one for this
/// code, too. An error is what `error` is for. A sub-operation says by a CASE that names another code than 0
/// that its codes mean something.
bool is_forgotten(const Icon& icon, const Icon& branch, const Ending& ending) {
  if (branch.otherwise.connected() || names_code(branch, ending.code)) return false;
  if (ending.normal()) return true;
  if (ending.kind == pan::Completion::Kind::error || ending.code < 0) return false;
  if (icon.kind != IconKind::sub_operation) return true;
  return std::any_of(branch.ways.begin(), branch.ways.end(), [](const Way& way) {
    return std::any_of(way.codes.begin(), way.codes.end(), [](int code) { return code != 0; });
  });
}

void check_endings(const Graph& graph, Place at, const Icon& icon, const Skills& skills,
                   const PossibleCodes& codes, Diagnostics& diagnostics) {
  const auto behind = graph.case_behind(at);
  for (const Ending& ending : endings_of(graph, at, skills, codes.exits)) {
    const auto way = route(graph, at, ending.code, ending.normal());
    const std::string meaning = completion_text(skills, icon, ending.code);
    if (!way) {
      Diagnostic& finding =
          diagnostics.report(Finding::code_not_handled, icon.where, ending.text(), icon.id, meaning);
      if (!icon.error.connected()) finding.fix = led_to_exit(graph, at, "error", false);
      continue;
    }
    if (!behind || !icon.error.connected() || !(way->where == icon.error.where)) continue;
    const Icon& branch = graph.icon({at.operation, *behind});
    if (!is_forgotten(icon, branch, ending)) continue;
    diagnostics.report(Finding::code_goes_to_error, branch.where, branch.id, ending.text(), icon.id, meaning)
        .note(icon.error.where, Remark::this_way);
  }
}

void check_ways(const Graph& graph, Place at, const Icon& icon, const CodeSet& here,
                Diagnostics& diagnostics) {
  for (const int code : here.list())
    if (!way_of(icon, code))
      diagnostics
          .report(Finding::case_lacks_code, icon.where, icon.id,
                  code == any_code ? "any other code" : fmt::format("code {}", code))
          .fix = led_to_exit(graph, at, "default", false);
  if (here.empty() || here.contains(any_code)) return;
  for (const Way& way : icon.ways)
    if (std::none_of(way.codes.begin(), way.codes.end(), [&](int code) { return here.contains(code); }))
      diagnostics.report(Finding::way_never_taken, way.where, fmt::format("{}", fmt::join(way.codes, " or ")),
                         icon.id);
}

}  // namespace

void check_codes(const Graph& graph, Place at, const Skills& skills, const PossibleCodes& codes,
                 Diagnostics& diagnostics) {
  const Icon& icon = graph.icon(at);
  if (has_completions(icon.kind)) check_endings(graph, at, icon, skills, codes, diagnostics);
  if (icon.kind == IconKind::branch)
    check_ways(graph, at, icon, codes.at[at.operation][at.icon], diagnostics);
}

}  // namespace pal::operations
