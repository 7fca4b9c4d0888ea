// Each icon against the template of its skill: parameters, ranges, codes, locations.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "operations/check.hpp"
#include "operations/codes.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "pal/support/nearest.hpp"

namespace pal::operations {
namespace {

std::string type_text(const pan::Parameter& parameter) {
  switch (parameter.type) {
    case pan::ScalarType::text:
      return "a text in double quotes";
    case pan::ScalarType::boolean:
      return "true or false";
    case pan::ScalarType::integer:
      return fmt::format("a whole number from {} to {}", parameter.low, parameter.high);
    case pan::ScalarType::real:
      break;
  }
  return fmt::format("a number from {} to {}{}{}", parameter.low, parameter.high,
                     parameter.unit.empty() ? "" : " ", parameter.unit);
}

bool is_text(char c) {
  return c >= ' ' && c <= '~';
}

bool fits(const pan::Parameter& parameter, const Parameter& given) {
  const Value& value = given.value;
  const bool number_wanted =
      parameter.type == pan::ScalarType::real || parameter.type == pan::ScalarType::integer;
  // How far a count goes is known when it runs.
  if (!given.count_of.empty()) return number_wanted;
  if (parameter.type == pan::ScalarType::boolean) return std::holds_alternative<bool>(value);
  if (parameter.type == pan::ScalarType::text) {
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr && text->size() <= pan::longest_text &&
           std::all_of(text->begin(), text->end(), is_text);
  }
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr || !(*number >= parameter.low && *number <= parameter.high)) return false;
  return parameter.type == pan::ScalarType::real || std::floor(*number) == *number;
}

class SkillChecks {
 public:
  SkillChecks(const Skills& skills, const std::optional<std::set<std::string>>& locations,
              Diagnostics& diagnostics)
      : skills_(skills), locations_(locations), diagnostics_(diagnostics) {}

  void check(const Icon& icon) {
    const auto found = skills_.find(icon.skill);
    if (found == skills_.end()) {
      std::vector<std::string> names;
      for (const auto& [name, skill] : skills_) names.push_back(name);
      const auto near = nearest(icon.skill, names);
      diagnostics_.report(Code::PAL1007, icon.subject, fmt::format("the cell has no skill '{}'", icon.skill),
                          near ? fmt::format("did you mean '{}'?", *near)
                               : "name a skill of the cell, or give its file with --skills");
      return;
    }
    const pan::Template& skill = found->second;
    for (const Parameter& given : icon.parameters) check_given(skill, given);
    for (const pan::Parameter& parameter : skill.parameters) check_location(icon, parameter);
  }

 private:
  void check_given(const pan::Template& skill, const Parameter& given) {
    std::vector<std::string> names;
    for (const pan::Parameter& parameter : skill.parameters) {
      names.push_back(parameter.name);
      if (parameter.name != given.name) continue;
      if (!fits(parameter, given))
        diagnostics_.report(
            Code::PAL1009, given.where,
            fmt::format("'{}' of skill '{}' cannot be {}", given.name, skill.name, to_text(given)),
            fmt::format("write {}", type_text(parameter)));
      return;
    }
    const auto near = nearest(given.name, names);
    diagnostics_.report(Code::PAL1008, given.name_where,
                        fmt::format("skill '{}' has no parameter '{}'", skill.name, given.name),
                        near            ? fmt::format("did you mean '{}'?", *near)
                        : names.empty() ? std::string("it has none")
                                        : fmt::format("it has {}", fmt::join(names, ", ")));
  }

  /// A text that the skill calls a location names a place that was taught.
  void check_location(const Icon& icon, const pan::Parameter& parameter) {
    if (!locations_ || parameter.type != pan::ScalarType::text ||
        parameter.description.find("location") == std::string::npos)
      return;
    std::string named = parameter.default_text;
    SourceSpan where = icon.subject;
    for (const Parameter& given : icon.parameters) {
      const auto* text = std::get_if<std::string>(&given.value);
      if (given.name != parameter.name || text == nullptr) continue;
      named = *text;
      where = given.where;
    }
    if (locations_->contains(named)) return;
    const auto near = nearest(named, {locations_->begin(), locations_->end()});
    diagnostics_.report(
        Code::PAL1010, where, fmt::format("location '{}' is not taught", named),
        near ? fmt::format("did you mean '{}'?", *near) : "teach it, or name one that is taught");
  }

  const Skills& skills_;
  const std::optional<std::set<std::string>>& locations_;
  Diagnostics& diagnostics_;
};

std::string completion_text(const Skills& skills, const Icon& icon, int code) {
  const auto skill = skills.find(icon.skill);
  if (skill == skills.end()) return {};
  for (const pan::Completion& completion : skill->second.completions)
    if (completion.code == code && !completion.description.empty())
      return fmt::format(": \"{}\"", completion.description);
  return {};
}

void check_codes(const Program& program, const Skills& skills, Diagnostics& diagnostics) {
  const PossibleCodes codes = possible_codes(program, skills);
  for (std::size_t o = 0; o < program.operations.size(); ++o) {
    const Operation& operation = program.operations[o];
    for (std::size_t i = 0; i < operation.icons.size(); ++i) {
      const Icon& icon = operation.icons[i];
      const std::set<int>& here = codes.at[o][i];
      if (has_completions(icon.kind)) {
        for (const auto& [code, normal] : completions_of(program, operation, icon, skills, codes.exits))
          if (!route(operation, icon, code, normal))
            diagnostics.report(Code::PAL1006, icon.where,
                               fmt::format("no icon handles code {} of '{}'{}", code, icon.id,
                                           completion_text(skills, icon, code)),
                               "the operation ends there; connect 'error', or put a CASE behind it");
      }
      if (icon.kind != IconKind::branch || here.empty()) continue;
      for (const int code : here)
        if (!way_of(icon, code))
          diagnostics.report(Code::PAL1006, icon.where,
                             fmt::format("CASE '{}' has no way for code {}, which can come", icon.id, code),
                             "the operation ends there; add a way for it, or a default");
      for (const Way& way : icon.ways)
        if (std::none_of(way.codes.begin(), way.codes.end(), [&](int code) { return here.contains(code); }))
          diagnostics.report(
              Code::PAL1016, way.where,
              fmt::format("code {1} never comes to CASE '{0}'", icon.id, fmt::join(way.codes, " or ")),
              "remove the way, or correct the code");
    }
  }
}

}  // namespace

void check_skills(const Program& program, const Skills& skills,
                  const std::optional<std::set<std::string>>& locations, Diagnostics& diagnostics) {
  SkillChecks checks(skills, locations, diagnostics);
  for (const Operation& operation : program.operations)
    for (const Icon& icon : operation.icons)
      if (icon.kind == IconKind::skill) checks.check(icon);
  check_codes(program, skills, diagnostics);
}

}  // namespace pal::operations
