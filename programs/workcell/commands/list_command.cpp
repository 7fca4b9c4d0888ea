// workcell list: skills with their parameters, scenes.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>
#include <variant>

#include "programs/workcell/options/command_line.hpp"
#include "programs/workcell/session/cell_runner.hpp"
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

void list_skill(const runtime::Skill& skill, const operations::DeclaredTimes& longest, std::ostream& out) {
  const runtime::SkillDescription& description = skill.description();
  out << "  " << description.name << '\n';
  for (const std::string_view text : description.descriptions) out << "    " << text << '\n';
  for (const runtime::ParameterSpec& parameter : description.parameters)
    out << fmt::format("    --set {}=…  {} ({})\n", parameter.name, parameter.description, range(parameter));
  for (const runtime::CompletionSpec& completion : description.completions) {
    out << fmt::format("    completion {} ({}): {}\n", completion.code, name(completion.kind),
                       completion.description);
    const auto time = longest.find({std::string(description.name), completion.code});
    if (time != longest.end()) out << fmt::format("      longest time in s: {}\n", time->second.text());
  }
}

/// All that an operation can be checked against, for programs.
void list_cell(const ListCommand& command, const std::vector<KnownSkill>& skills, std::ostream& out) {
  using Json = nlohmann::ordered_json;
  const sim::Scene scene =
      sim::find_scene(command.cell, {command.scene_folders.begin(), command.scene_folders.end()});
  sim::Cell cell(scene);
  const operations::Cell known = cell_of(cell, skills, scene, command.scene_folders);
  const auto sensors = [](const operations::Sensors& all) {
    Json json = Json::object();
    for (const auto& [name, each] : all)
      json[name] = {{"unit", each.unit}, {"description", each.description}};
    return json;
  };
  const auto longest = [](const operations::DeclaredTimes& all) {
    Json json = Json::object();
    for (const auto& [of, formula] : all) json[of.first][std::to_string(of.second)] = formula.text();
    return json;
  };
  Json further = Json::array();
  for (const KnownSkill& skill : skills) {
    if (skill.from.empty() || skill.pal_file.empty()) continue;
    Json texts = Json::object();
    for (const std::string& name : skill.text_names)
      texts[name] = std::get<std::string>(skill.texts->read(name));
    further.push_back({{"skill", skill.name},
                       {"from", skill.from},
                       {"pal", skill.pal_file},
                       {"environment", skill.environment_file},
                       {"texts", std::move(texts)}});
  }
  std::string folder;
  for (const std::string& each : command.skill_folders)
    if (folder.empty() && std::filesystem::is_directory(each)) folder = each;
  const Json json{{"workcell-cell", 1},
                  {"scene", scene.name},
                  {"skills", folder},
                  {"environment", folder + "/workcell.pal"},
                  {"further", further},
                  {"locations", *known.locations},
                  {"sensors", sensors(*known.sensors)},
                  {"figures", sensors(*known.figures)},
                  {"longest", longest(known.longest)},
                  {"unable", known.unable.empty() ? Json::object() : Json(known.unable)}};
  out << json.dump(1, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace

ExitStatus list(const ListCommand& command, const std::vector<KnownSkill>& skills, std::ostream& out) {
  if (!command.cell.empty()) {
    list_cell(command, skills, out);
    return ExitStatus::done;
  }
  out << "skills\n";
  const operations::DeclaredTimes longest = longest_of(skills);
  for (const KnownSkill& known : skills) list_skill(*known.make(), longest, out);
  out << "scenes\n";
  for (const sim::Scene& scene :
       sim::list_scenes({command.scene_folders.begin(), command.scene_folders.end()}))
    out << fmt::format("  {:<12} {}\n", scene.name, sim::describe_scene(scene));
  return ExitStatus::done;
}

}  // namespace pal::workcell
