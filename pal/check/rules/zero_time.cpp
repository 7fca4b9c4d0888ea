#include "pal/check/rules/zero_time.hpp"

#include <set>

namespace pal::check {

ZeroTimePaths::ZeroTimePaths(const pan::Network& network, const pan::Flow& flow)
    : network_(network), flow_(flow), modules_(network.modules.size(), false) {
  for (const auto& module : network.modules) forks_.emplace_back(module.body.nodes.size(), false);
  for (const auto module : pan::executed_first(network)) {
    const auto& nodes = network.modules[module.index()].body.nodes;
    if (nodes.empty()) continue;
    // An inner CONCURRENT stands behind the outer one in the text, and the outer one needs to know about it.
    for (auto i = nodes.size(); i-- > 0;) {
      if (std::holds_alternative<pan::Fork>(nodes[i].content))
        forks_[module.index()][i] = fork_passes(module, pan::NodeId(i));
    }
    modules_[module.index()] = passes(module, pan::NodeId(0), pan::NodeId(nodes.size() - 1));
  }
}

bool ZeroTimePaths::takes_no_time(pan::ModuleId module, pan::NodeId id) const {
  const auto& content = network_.modules[module.index()].body[id].content;
  if (const auto* execute = std::get_if<pan::Execute>(&content)) return modules_[execute->module.index()];
  if (std::holds_alternative<pan::Fork>(content)) return forks_[module.index()][id.index()];
  return !std::holds_alternative<pan::Wait>(content) && !std::holds_alternative<pan::WaitForStart>(content) &&
         !std::holds_alternative<pan::Send>(content) && !std::holds_alternative<pan::Perform>(content);
}

std::vector<pan::NodeId> ZeroTimePaths::next(pan::ModuleId module, pan::NodeId id) const {
  const auto& node = network_.modules[module.index()].body[id];
  if (std::holds_alternative<pan::Fork>(node.content)) return {node.mate};
  return flow_.next(module, id);
}

bool ZeroTimePaths::passes(pan::ModuleId module, pan::NodeId from, pan::NodeId end) const {
  std::set<pan::NodeId> seen{from};
  std::vector<pan::NodeId> open{from};
  while (!open.empty()) {
    const auto at = open.back();
    open.pop_back();
    if (at == end) return true;
    if (!takes_no_time(module, at)) continue;
    for (const auto to : next(module, at)) {
      if (seen.insert(to).second) open.push_back(to);
    }
  }
  return false;
}

bool ZeroTimePaths::fork_passes(pan::ModuleId module, pan::NodeId fork) const {
  bool any = false;
  for (const auto first : network_.modules[module.index()].body[fork].out) {
    if (!flow_.block_can_end(module, first)) continue;
    any = true;
    if (!passes(module, first, flow_.block_end(module, first))) return false;
  }
  return any;
}

}  // namespace pal::check
