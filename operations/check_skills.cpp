#include "operations/check_skills.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "operations/check_values.hpp"
#include "operations/cure.hpp"
#include "pal/support/finding.hpp"

namespace pal::operations {
namespace {

std::string listed(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

std::vector<std::string> names_of(const std::vector<pan::Parameter>& parameters) {
  std::vector<std::string> names;
  for (const pan::Parameter& each : parameters) names.push_back(each.name);
  return names;
}

}  // namespace

SkillChecks::SkillChecks(const Graph& graph, const Cell& cell, Diagnostics& diagnostics)
    : graph_(graph),
      cell_(cell),
      diagnostics_(diagnostics),
      location_arguments_(graph.program().operations.size()) {
  for (const auto& [name, skill] : *cell.skills) skill_names_.push_back(name);
  if (cell.locations) location_names_.assign(cell.locations->begin(), cell.locations->end());
  if (!cell.locations) return;
  for (const std::size_t operation : inner_first(graph))
    for (std::size_t i = 0; i < graph.program().operations[operation].icons.size(); ++i)
      note_locations({operation, i});
}

void SkillChecks::note_locations(Place at) {
  const Icon& icon = graph_.icon(at);
  for (const Parameter& given : icon.parameters)
    if (given.source.kind == Source::Kind::argument && names_location(at, icon, given))
      location_arguments_[at.operation].insert(given.source.name);
}

bool SkillChecks::names_location(Place at, const Icon& icon, const Parameter& given) const {
  if (const auto sub = graph_.sub_operation(at)) return location_arguments_[*sub].contains(given.name);
  const auto skill = cell_.skills->find(icon.skill);
  if (skill == cell_.skills->end()) return false;
  for (const pan::Parameter& each : skill->second.parameters)
    if (each.name == given.name) return each.location;
  return false;
}

void SkillChecks::check_operator(const Icon& icon, const std::string& whose,
                                 const std::vector<pan::Parameter>& parameters) {
  for (const OperatorMaySet& each : icon.operator_may_set) {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const pan::Parameter& one) { return one.name == each.parameter; });
    const auto names = names_of(parameters);
    if (found == parameters.end()) {
      diagnostics_
          .report(Finding::operator_sets_no_parameter, each.where, whose, each.parameter, listed(names))
          .suggest(suggestions_.nearest_to(each.parameter, names));
    } else if (const bool number =
                   found->type == pan::ScalarType::real || found->type == pan::ScalarType::integer;
               !number && (each.from || each.to)) {
      diagnostics_.report(Finding::range_of_no_number, each.where, each.parameter);
    } else if (number && ((each.from && *each.from < found->low) || (each.to && *each.to > found->high))) {
      diagnostics_.report(Finding::operator_beyond_range, each.where, each.parameter, whose,
                          fmt::to_string(found->low), fmt::to_string(found->high));
    }
  }
}

void SkillChecks::check(Place at, const Icon& icon) {
  if (icon.kind == IconKind::sub_operation) {
    if (const auto sub = graph_.sub_operation(at)) {
      const Operation& inside = graph_.program().operations[*sub];
      check_operator(icon, fmt::format("operation '{}'", inside.name), inside.arguments);
    }
    for (const Parameter& given : icon.parameters)
      if (const auto* text = std::get_if<std::string>(&given.value);
          text != nullptr && given.source.written() && names_location(at, icon, given))
        check_taught(*text, given.where);
    return;
  }
  const auto found = cell_.skills->find(icon.skill);
  if (found == cell_.skills->end()) {
    const auto near = suggestions_.nearest_to(icon.skill, skill_names_);
    diagnostics_.report(Finding::no_such_skill, icon.subject, icon.skill).suggest(near).fix =
        renamed(icon.subject, near);
    return;
  }
  if (const auto why = cell_.unable.find(icon.skill); why != cell_.unable.end())
    diagnostics_.report(Finding::cell_cannot_run_skill, icon.subject, icon.skill, why->second);
  const pan::Template& skill = found->second;
  const Operation& operation = graph_.program().operations[at.operation];
  check_operator(icon, fmt::format("skill '{}'", skill.name), skill.parameters);
  std::set<std::string> refused;
  for (const Parameter& given : icon.parameters)
    if (!check_given(skill, given, operation)) refused.insert(given.name);
  if (refused.empty()) check_together(icon);
  if (!cell_.locations) return;
  for (const pan::Parameter& parameter : skill.parameters)
    if (parameter.location && !refused.contains(parameter.name)) check_location(icon, parameter);
}

void SkillChecks::check_together(const Icon& icon) {
  const auto written = [](const Parameter& each) { return each.source.written(); };
  if (!cell_.refused_together || icon.parameters.empty() ||
      !std::all_of(icon.parameters.begin(), icon.parameters.end(), written))
    return;
  if (const auto why = cell_.refused_together(icon.skill, icon.parameters))
    diagnostics_.report(Finding::values_refused, icon.subject, icon.skill, *why);
}

void SkillChecks::check_arguments(std::size_t operation) {
  for (const pan::Parameter& argument : graph_.program().operations[operation].arguments)
    if (location_arguments_[operation].contains(argument.name))
      check_taught(argument.default_text, argument.where);
}

bool SkillChecks::check_given(const pan::Template& skill, const Parameter& given,
                              const Operation& operation) {
  for (const pan::Parameter& parameter : skill.parameters)
    if (parameter.name == given.name)
      return check_fit(parameter, given, operation, fmt::format("skill '{}'", skill.name), diagnostics_);
  const auto names = names_of(skill.parameters);
  const auto near = suggestions_.nearest_to(given.name, names);
  diagnostics_.report(Finding::no_such_parameter, given.name_where, skill.name, given.name, listed(names))
      .suggest(near)
      .fix = renamed(given.name_where, near);
  return false;
}

/// The text that is given, or else the default.
void SkillChecks::check_location(const Icon& icon, const pan::Parameter& parameter) {
  for (const Parameter& given : icon.parameters) {
    if (given.name != parameter.name) continue;
    if (given.source.written()) check_taught(std::get<std::string>(given.value), given.where);
    return;
  }
  check_taught(parameter.default_text, icon.subject);
}

void SkillChecks::check_taught(const std::string& location, SourceSpan where) {
  if (!cell_.locations || cell_.locations->contains(location)) return;
  const auto near = suggestions_.nearest_to(location, location_names_);
  Diagnostic& finding = diagnostics_.report(Finding::not_taught, where, location).suggest(near);
  // A default has no text of its own at the icon.
  if (where.end - where.begin == location.size() + 2) finding.fix = renamed(where, near);
}

}  // namespace pal::operations
