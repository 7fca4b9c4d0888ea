#include "programs/workcell/session/needed_tool.hpp"

#include <fmt/format.h>

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

}  // namespace

void check_tool(const runtime::Skill& skill, const sim::Scene& scene,
                const std::vector<std::string>& folders) {
  const sim::ToolKind tool = sim::tool_of(scene);
  for (const sim::ServedPort& port : sim::served_ports()) {
    if (!port.tool || *port.tool == tool) continue;
    for (const std::string_view device : skill.wiring().devices) {
      if (device != port.name) continue;
      const std::string scenes = scenes_with(*port.tool, folders);
      throw Failure(ExitStatus::wrong_specification, "scene " + scene.name,
                    fmt::format("skill {} needs the tool {}, and the tool of this scene is {}",
                                skill.description().name, sim::to_string(*port.tool), sim::to_string(tool)),
                    scenes.empty() ? fmt::format("write 'tool {}' into a scene", sim::to_string(*port.tool))
                                   : "choose one with --scene: " + scenes);
    }
  }
}

}  // namespace pal::workcell
