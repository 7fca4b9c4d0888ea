#include "programs/workcell/session/needed_tool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "programs/workcell/session/failure.hpp"
#include "sim/cell/served_port.hpp"

namespace pal::workcell {
namespace {

std::string scenes_with(sim::ToolKind tool, const std::vector<std::string>& folders) {
  std::string names;
  for (const sim::Scene& scene : sim::list_scenes({folders.begin(), folders.end()})) {
    try {
      if (sim::tool_of(scene) == tool) names += (names.empty() ? "" : ", ") + scene.name;
    } catch (const sim::SceneError&) {  // the choice of the scene reports it
    }
  }
  return names;
}

bool uses(const runtime::Skill& skill, std::string_view device) {
  const auto devices = skill.wiring().devices;
  return std::find(devices.begin(), devices.end(), device) != devices.end();
}

/// The tool that the skill needs and the scene lacks; nothing: it lacks none.
std::optional<sim::ToolKind> missing_tool(const runtime::Skill& skill, const sim::Scene& scene) {
  const auto needed = needed_tool(skill);
  return needed && *needed != sim::tool_of(scene) ? needed : std::nullopt;
}

std::string needs(sim::ToolKind tool, const sim::Scene& scene) {
  return fmt::format("needs the tool {}, and the tool of this scene is {}", sim::to_string(tool),
                     sim::to_string(sim::tool_of(scene)));
}

}  // namespace

std::optional<sim::ToolKind> needed_tool(const runtime::Skill& skill) {
  for (const sim::ServedPort& port : sim::served_ports())
    if (port.tool && uses(skill, port.name)) return port.tool;
  // Skills that press use the pad. What a person moves by hand may carry any tool.
  if (uses(skill, "alter") && uses(skill, "force-torque") && !uses(skill, "pendant"))
    return sim::ToolKind::pad;
  return std::nullopt;
}

std::optional<std::string> lacking_tool(const runtime::Skill& skill, const sim::Scene& scene,
                                        const std::vector<std::string>& folders) {
  const auto tool = missing_tool(skill, scene);
  if (!tool) return std::nullopt;
  const std::string scenes = scenes_with(*tool, folders);
  return fmt::format("it {}{}", needs(*tool, scene),
                     scenes.empty() ? "" : fmt::format("; these scenes have it: {}", scenes));
}

void check_tool(const runtime::Skill& skill, const sim::Scene& scene,
                const std::vector<std::string>& folders) {
  const auto tool = missing_tool(skill, scene);
  if (!tool) return;
  const std::string scenes = scenes_with(*tool, folders);
  throw Failure(ExitStatus::wrong_specification, "scene " + scene.name,
                fmt::format("skill {} {}", skill.description().name, needs(*tool, scene)),
                scenes.empty() ? fmt::format("write 'tool {}' into a scene", sim::to_string(*tool))
                               : "choose one with --scene: " + scenes);
}

}  // namespace pal::workcell
