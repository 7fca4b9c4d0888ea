// workcell list: skills with their parameters, scenes.
#include <fmt/format.h>

#include <ostream>

#include "programs/workcell/options/command_line.hpp"
#include "sim/scene.hpp"

namespace pal::workcell {
namespace {

const char* name(runtime::CompletionSpec::Kind kind) {
  if (kind == runtime::CompletionSpec::Kind::normal) return "normal";
  return kind == runtime::CompletionSpec::Kind::contingency ? "contingency" : "error";
}

std::string range(const runtime::ParameterSpec& parameter) {
  if (parameter.type == runtime::ParameterType::text)
    return fmt::format("up to {} characters, default \"{}\"", runtime::Text::capacity,
                       parameter.default_text);
  if (parameter.type == runtime::ParameterType::boolean)
    return fmt::format("0 or 1, default {:g}", parameter.default_value);
  const std::string unit = parameter.unit.empty() ? "" : " " + std::string(parameter.unit);
  return fmt::format("{:g} to {:g}{}, default {:g}", parameter.low, parameter.high, unit,
                     parameter.default_value);
}

void list_skill(const runtime::Skill& skill, std::ostream& out) {
  const runtime::SkillDescription& description = skill.description();
  out << "  " << description.name << '\n';
  for (const std::string_view text : description.descriptions) out << "    " << text << '\n';
  for (const runtime::ParameterSpec& parameter : description.parameters)
    out << fmt::format("    --set {}=…  {} ({})\n", parameter.name, parameter.description, range(parameter));
  for (const runtime::CompletionSpec& completion : description.completions)
    out << fmt::format("    completion {} ({}): {}\n", completion.code, name(completion.kind),
                       completion.description);
}

}  // namespace

ExitStatus list(const ListCommand& command, const std::vector<KnownSkill>& skills, std::ostream& out) {
  out << "skills\n";
  for (const KnownSkill& known : skills) list_skill(*known.make(), out);
  out << "scenes\n";
  for (const sim::Scene& scene :
       sim::list_scenes({command.scene_folders.begin(), command.scene_folders.end()}))
    out << fmt::format("  {:<12} {}\n", scene.name, sim::describe_scene(scene));
  return ExitStatus::done;
}

}  // namespace pal::workcell
