// Messages that no module sends or takes, and requests that no module answers.
#include <string>
#include <vector>

#include "pal/check/report.hpp"
#include "pal/check/rules/families.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

struct ChannelUse {
  bool sent = false;
  bool taken = false;
};

std::vector<ChannelUse> uses(const pan::Network& network) {
  std::vector<ChannelUse> result(network.channels.size());
  for (const auto& module : network.modules) {
    for (const auto& node : module.body.nodes) {
      if (const auto* send = std::get_if<pan::Send>(&node.content)) result[send->channel.index()].sent = true;
      if (const auto* wait = std::get_if<pan::Wait>(&node.content)) {
        for (const auto channel : wait->channels) result[channel.index()].taken = true;
      }
    }
  }
  return result;
}

/// Does what its body says. Of others the environment says what they do.
bool has_body(const pan::Network& network, const pan::Party& party) {
  const auto* module = std::get_if<pan::ModuleId>(&party);
  return module != nullptr && !network.modules[module->index()].body.empty();
}

bool is_request(const pan::Network& network, const pan::Channel& channel) {
  return network.messages[channel.message.index()].asks_for.valid();
}

std::string send_text(const pan::Network& network, const pan::Channel& channel) {
  const auto& message = network.messages[channel.message.index()].name;
  return "TXM( " + message + (is_request(network, channel) ? " from " : " to ") +
         party_name(network, channel.receiver) + " )";
}

std::string wait_text(const pan::Network& network, const pan::Channel& channel) {
  return "WTM( " + network.messages[channel.message.index()].name + " from " +
         party_name(network, channel.sender) + " )";
}

void note_module(const pan::Network& network, const pan::Party& party, Diagnostic& finding) {
  if (const auto* module = std::get_if<pan::ModuleId>(&party)) {
    const auto& found = network.modules[module->index()];
    finding.note(found.where, Remark::name_declared, found.name);
  }
}

void check_idle_modules(const pan::Network& network, Diagnostics& diagnostics) {
  std::vector<bool> talks(network.modules.size(), false);
  for (const auto& channel : network.channels) {
    for (const auto& party : {channel.sender, channel.receiver}) {
      if (const auto* module = std::get_if<pan::ModuleId>(&party)) talks[module->index()] = true;
    }
  }
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    const auto& module = network.modules[i];
    if (talks[i] || module.executed_by.valid() || pan::ModuleId(i) == network.main) continue;
    if (module.kind == pan::ModuleKind::contingency_module) continue;  // has a finding of its own
    auto& finding = diagnostics.report(Finding::module_without_messages, network.skill.where,
                                       network.skill.name, kind_text(module.kind), module.name);
    finding.note(module.where, Remark::declared_here);
  }
}

}  // namespace

void check_channels(const pan::Network& network, Diagnostics& diagnostics) {
  const auto used = uses(network);
  for (std::size_t i = 0; i < network.channels.size(); ++i) {
    const auto& channel = network.channels[i];
    const auto& message = network.messages[channel.message.index()].name;
    const auto& sender = party_name(network, channel.sender);
    const auto& receiver = party_name(network, channel.receiver);
    if (channel.sender == channel.receiver) continue;
    if (!used[i].sent && has_body(network, channel.sender)) {
      auto& finding = diagnostics.report(Finding::never_sends, channel.where, sender, message, receiver,
                                         send_text(network, channel));
      note_module(network, channel.sender, finding);
    } else if (!used[i].taken && has_body(network, channel.receiver)) {
      auto& finding = diagnostics.report(Finding::never_waits, channel.where, receiver, message, sender,
                                         wait_text(network, channel));
      note_module(network, channel.receiver, finding);
    } else if (is_request(network, channel) && !channel.answer.valid()) {
      const auto& answer = network.messages[network.messages[channel.message.index()].asks_for.index()].name;
      diagnostics.report(Finding::never_answers, channel.where, receiver, sender, answer);
    }
  }
  check_idle_modules(network, diagnostics);
}

}  // namespace pal::check
