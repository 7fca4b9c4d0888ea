// The part of a skill's document about its sensors.
#include <algorithm>
#include <utility>

#include "pal/doc/parts.hpp"

namespace pal::doc {

namespace {

const pan::Module* module_of(const pan::Network& network, const pan::Party& party) {
  const auto* id = std::get_if<pan::ModuleId>(&party);
  return id == nullptr ? nullptr : &network.modules[id->index()];
}

std::vector<Line> drivers_of(const pan::Network& network, pan::ModuleId sensor) {
  std::vector<const pan::Module*> drivers;
  for (const auto& channel : network.channels) {
    if (channel.receiver != pan::Party(sensor)) continue;
    const auto* module = module_of(network, channel.sender);
    if (module == nullptr || module->kind != pan::ModuleKind::sensor_driver) continue;
    if (std::find(drivers.begin(), drivers.end(), module) == drivers.end()) drivers.push_back(module);
  }
  std::vector<Line> lines;
  for (const auto* driver : drivers) lines.push_back(named(driver->name, driver->descriptions));
  return lines;
}

std::vector<Line> information_of(const pan::Network& network, pan::ModuleId sensor) {
  std::vector<Line> lines;
  std::vector<pan::MessageId> seen;
  for (const auto& channel : network.channels) {
    const auto& message = network.messages[channel.message.index()];
    const auto* receiver = module_of(network, channel.receiver);
    const bool down = receiver == nullptr || receiver->kind == pan::ModuleKind::sensor_driver;
    if (channel.sender != pan::Party(sensor) || message.asks_for.valid() || down) continue;
    if (std::find(seen.begin(), seen.end(), channel.message) != seen.end()) continue;
    seen.push_back(channel.message);
    lines.push_back(code(message.name) + text(": " + content_of(message)));
  }
  return lines;
}

std::vector<Line> methods_of(const pan::Network& network, pan::ModuleId sensor) {
  std::vector<Line> lines;
  for (const auto& method : network.modules[sensor.index()].methods) lines.push_back(text(method));
  for (const auto& activity : network.activities) {
    if (activity.module != sensor) continue;
    const auto names = [&](const std::vector<pan::MessageId>& messages) {
      std::vector<std::string> result;
      for (const auto id : messages) result.push_back(network.messages[id.index()].name);
      return codes(result);
    };
    auto line = code(activity.name);
    if (!activity.reads.empty()) line = line + text(" from ") + names(activity.reads);
    if (!activity.writes.empty()) line = line + text(" makes ") + names(activity.writes);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

Part sensor_part(const pan::Network& network, pan::ModuleId sensor) {
  const auto& module = network.modules[sensor.index()];
  Part part{"Logical Sensor Template: " + module.name, {}};
  part.sections.push_back(paragraphs("Textual Description", module.descriptions));
  part.sections.push_back(items("Sensor Drivers", drivers_of(network, sensor)));
  part.sections.push_back(items("Logical Sensor Methods", methods_of(network, sensor)));
  part.sections.push_back(items("Parameter Vector", information_of(network, sensor)));
  return part;
}

}  // namespace pal::doc
