#include "pal/check/rules/layers.hpp"

#include <set>
#include <string>
#include <utility>

#include "pal/check/report.hpp"
#include "pal/check/rules/families.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

Layer layer(const pan::Network& network, const pan::Party& party) {
  const auto* module = std::get_if<pan::ModuleId>(&party);
  if (module == nullptr) return Layer::device;
  return layer_of(network.modules[module->index()].kind);
}

std::string described(const pan::Network& network, const pan::Party& party) {
  const auto* module = std::get_if<pan::ModuleId>(&party);
  const auto kind = module == nullptr ? "device" : kind_text(network.modules[module->index()].kind);
  return kind + " " + quoted(party_name(network, party));
}

std::string partners(Layer layer) {
  switch (layer) {
    case Layer::skill:
      return "go by way of a neighbour: skill and contingency modules talk with logical sensors and machine "
             "controllers";
    case Layer::logical_sensor:
      return "go by way of a neighbour: logical sensors talk with sensor drivers below and skill modules "
             "above";
    case Layer::machine_controller:
      return "go by way of a neighbour: machine controllers talk with skill modules and with devices";
    case Layer::sensor_driver:
      return "go by way of a neighbour: sensor drivers talk with logical sensors and with devices";
    case Layer::device:
      return "go by way of a neighbour: only sensor drivers and machine controllers talk with devices";
  }
  return {};
}

}  // namespace

Layer layer_of(std::optional<pan::ModuleKind> kind) {
  if (!kind) return Layer::device;
  switch (*kind) {
    case pan::ModuleKind::skill_module:
    case pan::ModuleKind::contingency_module:
      return Layer::skill;
    case pan::ModuleKind::logical_sensor:
      return Layer::logical_sensor;
    case pan::ModuleKind::machine_controller:
      return Layer::machine_controller;
    case pan::ModuleKind::sensor_driver:
      return Layer::sensor_driver;
  }
  return Layer::device;
}

bool may_talk(Layer a, Layer b) {
  if (b < a) std::swap(a, b);
  switch (a) {
    case Layer::skill:
      return b == Layer::logical_sensor || b == Layer::machine_controller;
    case Layer::logical_sensor:
      return b == Layer::sensor_driver;
    case Layer::machine_controller:
    case Layer::sensor_driver:
      return b == Layer::device;
    case Layer::device:
      return false;
  }
  return false;
}

void check_layers(const pan::Network& network, Diagnostics& diagnostics) {
  std::set<std::pair<pan::Party, pan::Party>> seen;
  for (const auto& channel : network.channels) {
    auto pair = std::pair(channel.sender, channel.receiver);
    if (pair.second < pair.first) std::swap(pair.first, pair.second);
    if (!seen.insert(pair).second) continue;
    if (channel.sender == channel.receiver) {
      diagnostics.report(Finding::talks_to_itself, channel.where, party_name(network, channel.sender));
      continue;
    }
    const auto from = layer(network, channel.sender);
    const auto to = layer(network, channel.receiver);
    if (may_talk(from, to)) continue;
    diagnostics.report(Finding::may_not_talk, channel.where, described(network, channel.sender),
                       described(network, channel.receiver), partners(from == Layer::device ? to : from));
  }
}

}  // namespace pal::check
