// Requests for one answer in two blocks at once.
#include <map>

#include "pal/check/rules/blocks.hpp"
#include "pal/check/rules/families.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

void check_asking_blocks(const pan::Network& network, pan::ModuleId module, const pan::Node& fork,
                         Diagnostics& diagnostics) {
  std::map<pan::ChannelId, SourceSpan> earlier;  // the first request in a block before
  for (std::size_t block = 0; block < fork.out.size(); ++block) {
    std::map<pan::ChannelId, SourceSpan> requests;
    each_node_of_block(network, module, fork, block, [&](const pan::Node& node) {
      const auto* send = std::get_if<pan::Send>(&node.content);
      if (send == nullptr || !network.channels[send->channel.index()].answer.valid()) return;
      requests.emplace(send->channel, node.where);
    });
    for (const auto& [request, where] : requests) {
      const auto [entry, fresh] = earlier.emplace(request, where);
      if (fresh) continue;
      const pan::Channel& channel = network.channels[request.index()];
      const pan::Channel& answer = network.channels[channel.answer.index()];
      auto& finding = diagnostics.report(Finding::requested_in_two_blocks, where,
                                         network.messages[answer.message.index()].name,
                                         party_name(network, channel.receiver));
      finding.note(entry->second, Remark::also_requested);
    }
  }
}

}  // namespace

void check_askers(const pan::Network& network, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    for (const auto& node : network.modules[i].body.nodes) {
      if (std::holds_alternative<pan::Fork>(node.content))
        check_asking_blocks(network, pan::ModuleId(i), node, diagnostics);
    }
  }
}

}  // namespace pal::check
