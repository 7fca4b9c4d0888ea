#include "pal/doc/facts.hpp"

#include "pal/doc/parts.hpp"
#include "pal/pan/dump.hpp"

namespace pal::doc {

namespace {

Line names_of(const pan::Network& network, const std::vector<pan::MessageId>& messages) {
  std::vector<std::string> names;
  for (const auto id : messages) names.push_back(network.messages[id.index()].name);
  return codes(names);
}

Line name_of(const pan::Network& network, pan::ModuleId module) {
  return module.valid() ? code(network.modules[module.index()].name) : Line{};
}

std::vector<pan::DeviceId> devices_of(const pan::Network& network, pan::ModuleId module) {
  std::vector<bool> talks(network.devices.size());
  for (const auto& channel : network.channels) {
    const auto mark = [&](const pan::Party& one, const pan::Party& other) {
      const auto* device = std::get_if<pan::DeviceId>(&other);
      if (device != nullptr && one == pan::Party(module)) talks[device->index()] = true;
    };
    mark(channel.sender, channel.receiver);
    mark(channel.receiver, channel.sender);
  }
  std::vector<pan::DeviceId> result;
  for (std::size_t i = 0; i < talks.size(); ++i) {
    if (talks[i]) result.emplace_back(i);
  }
  return result;
}

}  // namespace

std::vector<Fact> facts_of(const pan::Network& network, pan::MessageId message) {
  std::string ways;
  for (const auto& channel : network.channels) {
    if (channel.message != message) continue;
    ways += (ways.empty() ? "" : ", ") + party_name(network, channel.sender) + " → " +
            party_name(network, channel.receiver);
  }
  return {{"Content", text(content_of(network.messages[message.index()]))}, {"Ways", text(ways)}};
}

std::vector<Fact> facts_of(const pan::Network& network, pan::ConditionId condition) {
  const auto& of = network.conditions[condition.index()];
  return {{"Meaning", text(of.description)},
          {"Set by", name_of(network, of.writer)},
          {"From", names_of(network, of.from)}};
}

std::vector<Fact> facts_of(const pan::Network& network, pan::ActivityId activity) {
  const auto& of = network.activities[activity.index()];
  return {{"Module", name_of(network, of.module)},
          {"Reads", names_of(network, of.reads)},
          {"Writes", names_of(network, of.writes)}};
}

Line line_of(const pan::Network& network, pan::ModuleId module) {
  const auto& of = network.modules[module.index()];
  Line line = named(of.name, of.descriptions);
  for (const auto device : devices_of(network, module)) {
    const auto& known = network.devices[device.index()];
    line = line + text(". It drives ") + code(known.name) +
           text(known.description.empty() ? "" : ", " + known.description);
  }
  return line;
}

}  // namespace pal::doc
