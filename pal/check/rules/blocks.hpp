// The blocks of a CONCURRENT, which run at the same time.
#pragma once

#include <set>

#include "pal/pan/network.hpp"

namespace pal::check {

/// Calls `visit( node )` for the nodes [begin, end) of a module, and for those of the modules that they
/// execute, each once.
template <class Visit>
void each_node(const pan::Network& network, pan::ModuleId module, std::size_t begin, std::size_t end,
               std::set<pan::ModuleId>& entered, const Visit& visit) {
  const auto& nodes = network.modules[module.index()].body.nodes;
  for (auto i = begin; i < end; ++i) {
    visit(nodes[i]);
    const auto* execute = std::get_if<pan::Execute>(&nodes[i].content);
    if (execute == nullptr || !entered.insert(execute->module).second) continue;
    each_node(network, execute->module, 0, network.modules[execute->module.index()].body.nodes.size(),
              entered, visit);
  }
}

/// The same for block `block` of a fork.
template <class Visit>
void each_node_of_block(const pan::Network& network, pan::ModuleId module, const pan::Node& fork,
                        std::size_t block, const Visit& visit) {
  const auto end = block + 1 < fork.out.size() ? fork.out[block + 1].index() : fork.mate.index();
  std::set<pan::ModuleId> entered;
  each_node(network, module, fork.out[block].index(), end, entered, visit);
}

}  // namespace pal::check
