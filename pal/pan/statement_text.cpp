// A statement of a network as people read it: "TXM( motion to MC1 )".
#include <type_traits>

#include "pal/pan/dump.hpp"
#include "pal/support/duration_text.hpp"

namespace pal::pan {

namespace {

/// One that its name alone stands for.
bool is_bare(const Guard& guard) {
  return guard.kind == Guard::Kind::equals && guard.value;
}

std::string joined(const Network& network, const Guard& guard, const char* word) {
  std::string result;
  for (const auto& term : guard.terms) {
    if (!result.empty()) result += word;
    // Terms of another precedence stand in parentheses.
    const bool simple = term.kind == Guard::Kind::equals || term.kind == Guard::Kind::negation;
    result += simple ? guard_text(network, term) : "( " + guard_text(network, term) + " )";
  }
  return result;
}

struct Speller {
  const Network& network;

  std::string condition(ConditionId id) const { return network.conditions[id.index()].name; }
  std::string source(ChannelId id) const {
    const auto& channel = network.channels[id.index()];
    return "( " + network.messages[channel.message.index()].name + " from " +
           party_name(network, channel.sender) + " )";
  }

  std::string operator()(const Start&) const { return "start"; }
  std::string operator()(const End&) const { return "end"; }
  std::string operator()(const WaitForStart&) const { return "WTM( Coordinator )"; }
  std::string operator()(const Wait& wait) const {
    std::string text = "WTM";
    if (wait.channels.size() == 1) text += source(wait.channels.front());
    if (wait.channels.size() != 1) text += " FIRST";
    if (wait.within) text += " WITHIN " + to_text(*wait.within);
    if (wait.channels.size() != 1) {
      for (const auto channel : wait.channels) text += " " + source(channel);
    }
    return text;
  }
  std::string operator()(const Send& send) const {
    const auto& channel = network.channels[send.channel.index()];
    const auto& message = network.messages[channel.message.index()];
    const char* way = message.asks_for.valid() ? " from " : " to ";
    return "TXM( " + message.name + way + party_name(network, channel.receiver) + " )";
  }
  std::string operator()(const Complete& complete) const {
    return "TXM( Completion Protocol " + std::to_string(complete.code) + " )";
  }
  std::string operator()(const Set& set) const {
    const char* value = !set.value ? "" : *set.value ? " = TRUE" : " = FALSE";
    return "SPC( " + condition(set.condition) + value + " )";
  }
  std::string operator()(const Read& read) const { return "RPC( " + condition(read.condition) + " )"; }
  std::string operator()(const Perform& perform) const {
    return network.activities[perform.activity.index()].name;
  }
  std::string operator()(const Execute& execute) const {
    return "Execute " + network.modules[execute.module.index()].name;
  }
  std::string operator()(const Nothing&) const { return "Do Nothing"; }
  std::string operator()(const Choose&) const { return "CASE"; }
  std::string operator()(const Merge&) const { return "END CASE"; }
  std::string operator()(const Loop&) const { return "REPEAT"; }
  std::string operator()(const Until& until) const {
    return until.guard ? "UNTIL( " + guard_text(network, *until.guard) + " )" : "UNTIL( forever )";
  }
  std::string operator()(const Fork&) const { return "CONCURRENT"; }
  std::string operator()(const Join&) const { return "END CONCURRENT"; }
};

}  // namespace

std::string guard_text(const Network& network, const Guard& guard) {
  switch (guard.kind) {
    case Guard::Kind::equals:
      return network.conditions[guard.condition.index()].name + (guard.value ? " = TRUE" : " = FALSE");
    case Guard::Kind::all_of:
      return joined(network, guard, " AND ");
    case Guard::Kind::any_of:
      return joined(network, guard, " OR ");
    case Guard::Kind::negation:
      return is_bare(guard.terms.front())
                 ? "NOT " + network.conditions[guard.terms.front().condition.index()].name
                 : "NOT ( " + guard_text(network, guard.terms.front()) + " )";
  }
  return {};
}

std::string kind_text(ModuleKind kind) {
  switch (kind) {
    case ModuleKind::sensor_driver:
      return "sensor driver";
    case ModuleKind::logical_sensor:
      return "logical sensor";
    case ModuleKind::machine_controller:
      return "machine controller";
    case ModuleKind::skill_module:
      return "skill module";
    case ModuleKind::contingency_module:
      return "contingency module";
  }
  return {};
}

const std::string& party_name(const Network& network, const Party& party) {
  if (const auto* module = std::get_if<ModuleId>(&party)) return network.modules[module->index()].name;
  return network.devices[std::get<DeviceId>(party).index()].name;
}

std::string statement_text(const Network& network, ModuleId module, NodeId node) {
  const auto& graph = network.modules[module.index()].body;
  const auto& content = graph[node].content;
  if (std::holds_alternative<Merge>(content) && graph[node].mate.valid() &&
      std::holds_alternative<Wait>(graph[graph[node].mate].content)) {
    return "END WTM";
  }
  return std::visit(Speller{network}, content);
}

}  // namespace pal::pan
