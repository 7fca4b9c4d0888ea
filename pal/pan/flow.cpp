#include "pal/pan/flow.hpp"

#include <algorithm>

namespace pal::pan {

Flow::Flow(const Network& network) : network_(network), can_end_(network.modules.size(), true) {
  for (const auto& module : network.modules) fork_can_end_.emplace_back(module.body.nodes.size(), false);
  for (const auto module : executed_first(network)) {
    const auto& graph = network.modules[module.index()].body;
    if (graph.empty()) continue;
    visit_forks(module);
    can_end_[module.index()] = reach(module, NodeId(0))[graph.nodes.size() - 1];
  }
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    const auto& graph = network.modules[i].body;
    reached_.push_back(graph.empty() ? std::vector<bool>{} : reach(ModuleId(i), NodeId(0)));
  }
}

std::vector<NodeId> Flow::next(ModuleId module, NodeId id) const {
  const auto& node = network_.modules[module.index()].body[id];
  auto result = node.out;
  if (std::holds_alternative<Complete>(node.content)) return {};
  if (const auto* execute = std::get_if<Execute>(&node.content)) {
    if (!can_end_[execute->module.index()]) return {};
  }
  if (std::holds_alternative<Until>(node.content)) result.push_back(node.mate);
  if (std::holds_alternative<Fork>(node.content) && fork_can_end(module, id)) result.push_back(node.mate);
  return result;
}

void Flow::visit_forks(ModuleId module) {
  const auto& nodes = network_.modules[module.index()].body.nodes;
  // An inner CONCURRENT stands behind the outer one in the text, and the outer one needs to know about it.
  for (auto i = nodes.size(); i-- > 0;) {
    if (!std::holds_alternative<Fork>(nodes[i].content)) continue;
    const auto can = [&](NodeId first) { return block_can_end(module, first); };
    fork_can_end_[module.index()][i] = std::any_of(nodes[i].out.begin(), nodes[i].out.end(), can);
  }
}

bool Flow::block_can_end(ModuleId module, NodeId first) const {
  return reach(module, first)[block_end(module, first).index()];
}

NodeId Flow::block_end(ModuleId module, NodeId first) const {
  // The first End that is not of a block within this one, counting CONCURRENT and END CONCURRENT in the order
  // of the text.
  const auto& nodes = network_.modules[module.index()].body.nodes;
  int depth = 0;
  auto at = first.index();
  while (depth > 0 || !std::holds_alternative<End>(nodes[at].content)) {
    if (std::holds_alternative<Fork>(nodes[at].content)) ++depth;
    if (std::holds_alternative<Join>(nodes[at].content)) --depth;
    ++at;
  }
  return NodeId(at);
}

std::vector<bool> Flow::reach(ModuleId module, NodeId from) const {
  std::vector<bool> seen(network_.modules[module.index()].body.nodes.size(), false);
  std::vector<NodeId> open{from};
  seen[from.index()] = true;
  while (!open.empty()) {
    const auto at = open.back();
    open.pop_back();
    for (const auto to : next(module, at)) {
      if (!to.valid() || seen[to.index()]) continue;
      seen[to.index()] = true;
      open.push_back(to);
    }
  }
  return seen;
}

std::vector<ModuleId> executed_first(const Network& network) {
  std::vector<std::size_t> missing(network.modules.size());  // by module: executed, and not listed yet
  for (const auto& module : network.modules) {
    if (module.executed_by.valid()) ++missing[module.executed_by.index()];
  }
  std::vector<ModuleId> order;
  for (std::size_t m = 0; m < missing.size(); ++m) {
    if (missing[m] == 0) order.emplace_back(m);
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto caller = network.modules[order[i].index()].executed_by;
    if (caller.valid() && --missing[caller.index()] == 0) order.push_back(caller);
  }
  for (std::size_t m = 0; m < missing.size(); ++m) {
    if (missing[m] > 0) order.emplace_back(m);
  }
  return order;
}

bool is_statement(const Content& content) {
  return !std::holds_alternative<Start>(content) && !std::holds_alternative<End>(content) &&
         !std::holds_alternative<Merge>(content) && !std::holds_alternative<Join>(content) &&
         !std::holds_alternative<Until>(content);
}

}  // namespace pal::pan
