#include "pal/check/rules/sensors.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

/// What a body does, by name, and the first statement that does it.
using Uses = std::map<std::string, SourceSpan>;

bool is_kind(const pan::Network& network, const pan::Party& party, pan::ModuleKind kind) {
  const auto* module = std::get_if<pan::ModuleId>(&party);
  return module != nullptr && network.modules[module->index()].kind == kind;
}

Uses drivers_of(const pan::Network& network, pan::ModuleId sensor) {
  Uses drivers;
  for (const auto& channel : network.channels) {
    for (const auto& [one, other] :
         {std::pair(channel.sender, channel.receiver), std::pair(channel.receiver, channel.sender)}) {
      if (one != pan::Party(sensor) || !is_kind(network, other, pan::ModuleKind::sensor_driver)) continue;
      drivers.emplace(network.modules[std::get<pan::ModuleId>(other).index()].name, channel.where);
    }
  }
  return drivers;
}

Uses information_of(const pan::Network& network, pan::ModuleId sensor) {
  Uses information;
  for (const auto& channel : network.channels) {
    const auto& message = network.messages[channel.message.index()];
    if (channel.sender != pan::Party(sensor) || message.asks_for.valid()) continue;
    if (is_kind(network, channel.receiver, pan::ModuleKind::sensor_driver)) continue;
    information.emplace(message.name, channel.where);
  }
  return information;
}

/// The two sides of a slot must name the same.
void compare(const syntax::NameSlot& slot, const Uses& uses, FindingWith<2> never, FindingWith<2> also,
             const std::string& sensor, Diagnostics& diagnostics) {
  for (const auto& name : slot.names) {
    if (uses.contains(name.text)) continue;
    diagnostics.report(never, name.where, sensor, name.text);
  }
  for (const auto& [used, where] : uses) {
    const bool named = std::any_of(slot.names.begin(), slot.names.end(),
                                   [&name = used](const auto& n) { return n.text == name; });
    if (named) continue;
    diagnostics.report(also, slot.where, sensor, used).note(where, Remark::talk_here);
  }
}

}  // namespace

void check_sensors(const Names& names, const pan::Network& network, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    const pan::ModuleId id(i);
    const auto* unit = names.unit_of(id);
    if (unit == nullptr || !unit->sensor.where.valid()) continue;
    if (unit->kind != pan::ModuleKind::logical_sensor) {
      diagnostics.report(Finding::slot_of_logical_sensor, unit->sensor.where);
      continue;
    }
    if (!unit->has_body) continue;
    if (const auto& drivers = unit->sensor.drivers) {
      compare(*drivers, drivers_of(network, id), Finding::sensor_never_talks, Finding::sensor_also_talks,
              unit->name.text, diagnostics);
    }
    if (const auto& returns = unit->sensor.returns) {
      compare(*returns, information_of(network, id), Finding::sensor_never_returns,
              Finding::sensor_also_returns, unit->name.text, diagnostics);
    }
  }
}

}  // namespace pal::check
