#include "analyzer/statement_text.hpp"

namespace pal::analyzer {
namespace {

using namespace pan;

std::string guard_text(const Network& network, const Guard& guard, bool nested) {
  switch (guard.kind) {
    case Guard::Kind::equals: {
      const std::string& name = network.conditions[guard.condition.index()].name;
      return guard.value ? name : name + " = FALSE";
    }
    case Guard::Kind::negation:
      return "NOT " + guard_text(network, guard.terms.front(), true);
    case Guard::Kind::all_of:
    case Guard::Kind::any_of: {
      std::string text;
      for (const Guard& term : guard.terms) {
        if (!text.empty()) text += guard.kind == Guard::Kind::all_of ? " AND " : " OR ";
        text += guard_text(network, term, true);
      }
      return nested ? "( " + text + " )" : text;
    }
  }
  return {};
}

std::string message_text(const Network& network, const Channel& channel, bool sending) {
  const Message& message = network.messages[channel.message.index()];
  if (message.asks_for.valid()) {
    const std::string& asked = network.messages[message.asks_for.index()].name;
    if (sending) return "request " + asked + " from " + party_name(network, channel.receiver);
    return asked + " request from " + party_name(network, channel.sender);
  }
  if (sending) return message.name + " to " + party_name(network, channel.receiver);
  return message.name + " from " + party_name(network, channel.sender);
}

struct Writer {
  const Network& network;

  std::string operator()(const Wait& wait) const {
    std::string text = "WTM( ";
    for (std::size_t i = 0; i < wait.channels.size(); ++i) {
      if (i != 0) text += " OR ";
      text += message_text(network, network.channels[wait.channels[i].index()], false);
    }
    return text + " )";
  }
  std::string operator()(const Send& send) const {
    return "TXM( " + message_text(network, network.channels[send.channel.index()], true) + " )";
  }
  std::string operator()(const Complete& complete) const {
    return "TXM( Completion Protocol " + std::to_string(complete.code) + " )";
  }
  std::string operator()(const Set& set) const {
    std::string text = "SPC( " + network.conditions[set.condition.index()].name;
    if (set.value) text += *set.value ? " = TRUE" : " = FALSE";
    return text + " )";
  }
  std::string operator()(const Read& read) const {
    return "RPC( " + network.conditions[read.condition.index()].name + " )";
  }
  std::string operator()(const Perform& perform) const { return network.activities[perform.activity.index()].name; }
  std::string operator()(const Execute& execute) const {
    return "Execute " + network.modules[execute.module.index()].name;
  }
  std::string operator()(const Until& until) const {
    return "UNTIL( " + (until.guard ? guard_text(network, *until.guard, false) : std::string("forever")) + " )";
  }
  std::string operator()(const Start&) const { return "BEGIN"; }
  std::string operator()(const End&) const { return "END"; }
  std::string operator()(const WaitForStart&) const { return "WTM( Coordinator )"; }
  std::string operator()(const Nothing&) const { return "Do Nothing"; }
  std::string operator()(const Choose&) const { return "CASE"; }
  std::string operator()(const Merge&) const { return "END CASE"; }
  std::string operator()(const Loop&) const { return "REPEAT"; }
  std::string operator()(const Fork&) const { return "CONCURRENT"; }
  std::string operator()(const Join&) const { return "END CONCURRENT"; }
};

}  // namespace

std::string statement_text(const Network& network, const Node& node) {
  return std::visit(Writer{network}, node.content);
}

std::string party_name(const Network& network, const Party& party) {
  if (const auto* module = std::get_if<ModuleId>(&party)) return network.modules[module->index()].name;
  return network.devices[std::get<DeviceId>(party).index()].name;
}

}  // namespace pal::analyzer
