#include "pal/check/network/build_network.hpp"

#include <map>
#include <utility>

#include "pal/check/network/build_body.hpp"
#include "pal/check/network/build_template.hpp"
#include "pal/check/network/calls.hpp"
#include "pal/check/network/names.hpp"
#include "pal/check/network/requirements.hpp"
#include "pal/check/rules/sensors.hpp"

namespace pal::check {

namespace {

/// The module under whose name a module talks: the one that executes it, or itself.
pan::ModuleId speaker_of(pan::ModuleId module, const pan::Network& network) {
  // In a circle, an error that is reported elsewhere, any of them will do.
  for (std::size_t steps = network.modules.size(); steps > 0; --steps) {
    const pan::ModuleId caller = network.modules[module.index()].executed_by;
    if (!caller.valid()) break;
    module = caller;
  }
  return module;
}

void build_bodies(Names& names, pan::Network& network, Diagnostics& diagnostics) {
  enter_calls(names, network, diagnostics);
  // Bodies may name modules that the template forgot: these come to the end of the list while it is walked.
  for (std::size_t i = 0; i < network.modules.size(); ++i) names.enter_activities(pan::ModuleId(i));
  std::size_t with_activities = network.modules.size();
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    const pan::ModuleId id(i);
    if (i >= with_activities) {
      enter_calls(names, network, diagnostics);
      names.enter_activities(id);
      with_activities = i + 1;
    }
    build_body(id, speaker_of(id, network), names, network, diagnostics);
  }
}

void connect_answers(pan::Network& network) {
  std::map<std::tuple<pan::Party, pan::MessageId, pan::Party>, pan::ChannelId> index;
  for (std::size_t i = 0; i < network.channels.size(); ++i) {
    const auto& channel = network.channels[i];
    index.emplace(std::tuple(channel.sender, channel.message, channel.receiver), pan::ChannelId(i));
  }
  for (auto& channel : network.channels) {
    const auto answer = network.messages[channel.message.index()].asks_for;
    if (!answer.valid()) continue;
    const auto found = index.find(std::tuple(channel.receiver, answer, channel.sender));
    if (found != index.end()) channel.answer = found->second;
  }
}

void connect_writers(pan::Network& network) {
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    for (const auto& node : network.modules[i].body.nodes) {
      const auto* set = std::get_if<pan::Set>(&node.content);
      if (set == nullptr) continue;
      auto& writer = network.conditions[set->condition.index()].writer;
      if (!writer.valid()) writer = pan::ModuleId(i);
    }
  }
}

pan::ModuleId waits_for_start(const pan::Network& network) {
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    for (const auto& node : network.modules[i].body.nodes) {
      if (std::holds_alternative<pan::WaitForStart>(node.content)) return pan::ModuleId(i);
    }
  }
  return {};
}

}  // namespace

pan::Network build_network(const Scope& scope, const syntax::SkillUnit& skill, Diagnostics& diagnostics) {
  pan::Network network;
  Names names(scope, false, network, diagnostics);
  build_template(skill, names, network, diagnostics);
  build_bodies(names, network, diagnostics);
  connect_answers(network);
  connect_writers(network);
  network.main = waits_for_start(network);
  build_requirements(skill, names, network, diagnostics);
  if (names.all_known()) check_sensors(names, network, diagnostics);
  return network;
}

pan::Network build_sketch(const Scope& scope, const std::string& name, SourceSpan where,
                          Diagnostics& diagnostics) {
  pan::Network network;
  network.skill.name = name;
  network.skill.where = where;
  Names names(scope, true, network, diagnostics);
  for (const auto* module : scope.modules.all()) names.module(module->name, true);
  build_bodies(names, network, diagnostics);
  connect_answers(network);
  connect_writers(network);
  network.main = waits_for_start(network);
  return network;
}

}  // namespace pal::check
