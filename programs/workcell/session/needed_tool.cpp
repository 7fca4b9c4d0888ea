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

/// The port of the tool that the skill needs and the scene lacks; nothing: it lacks none.
std::optional<sim::ServedPort> missing_port(const runtime::Skill& skill, const sim::Scene& scene) {
  const sim::ToolKind tool = sim::tool_of(scene);
  for (const sim::ServedPort& port : sim::served_ports()) {
    if (!port.tool || *port.tool == tool) continue;
    for (const std::string_view device : skill.wiring().devices)
      if (device == port.name) return port;
  }
  return std::nullopt;
}

std::string needs(const sim::ServedPort& port, const sim::Scene& scene) {
  return fmt::format("needs the tool {}, and the tool of this scene is {}", sim::to_string(*port.tool),
                     sim::to_string(sim::tool_of(scene)));
}

}  // namespace

std::optional<std::string> lacking_tool(const runtime::Skill& skill, const sim::Scene& scene,
                                        const std::vector<std::string>& folders) {
  const auto port = missing_port(skill, scene);
  if (!port) return std::nullopt;
  const std::string scenes = scenes_with(*port->tool, folders);
  return fmt::format("it {}{}", needs(*port, scene),
                     scenes.empty() ? "" : fmt::format("; these scenes have it: {}", scenes));
}

void check_tool(const runtime::Skill& skill, const sim::Scene& scene,
                const std::vector<std::string>& folders) {
  const auto port = missing_port(skill, scene);
  if (!port) return;
  const std::string scenes = scenes_with(*port->tool, folders);
  throw Failure(ExitStatus::wrong_specification, "scene " + scene.name,
                fmt::format("skill {} {}", skill.description().name, needs(*port, scene)),
                scenes.empty() ? fmt::format("write 'tool {}' into a scene", sim::to_string(*port->tool))
                               : "choose one with --scene: " + scenes);
}

}  // namespace pal::workcell
