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

}  // namespace

std::optional<sim::ToolKind> needed_tool(const runtime::Skill& skill) {
  for (const sim::ServedPort& port : sim::served_ports())
    if (port.tool && uses(skill, port.name)) return port.tool;
  if (uses(skill, "alter") && uses(skill, "force-torque")) return sim::ToolKind::pad;
  return std::nullopt;
}

void check_tool(const runtime::Skill& skill, const sim::Scene& scene,
                const std::vector<std::string>& folders) {
  const sim::ToolKind tool = sim::tool_of(scene);
  const auto needed = needed_tool(skill);
  if (!needed || *needed == tool) return;
  const std::string scenes = scenes_with(*needed, folders);
  throw Failure(ExitStatus::wrong_specification, "scene " + scene.name,
                fmt::format("skill {} needs the tool {}, and the tool of this scene is {}",
                            skill.description().name, sim::to_string(*needed), sim::to_string(tool)),
                scenes.empty() ? fmt::format("write 'tool {}' into a scene", sim::to_string(*needed))
                               : "choose one with --scene: " + scenes);
}

}  // namespace pal::workcell
