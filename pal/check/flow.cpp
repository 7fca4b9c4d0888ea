#include "pal/check/flow.hpp"

#include <algorithm>

namespace pal::frontend {

Flow::Flow(const pan::Network& network) : network_(network), can_end_(network.modules.size(), true) {
  for (const auto& module : network.modules) fork_can_end_.emplace_back(module.body.nodes.size(), false);
  // Whether a module can end depends on those it executes: start from "all can" and take away until nothing
  // changes. A circle of Execute is an error of its own, and comes out as "cannot end" or not at all.
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < network.modules.size(); ++i) {
      const auto& graph = network.modules[i].body;
      if (graph.empty() || !can_end_[i]) continue;
      visit_forks(pan::ModuleId(i));
      const pan::NodeId end(graph.nodes.size() - 1);
      if (!reach(pan::ModuleId(i), pan::NodeId(0))[end.index()]) {
        can_end_[i] = false;
        changed = true;
      }
    }
  }
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    const auto& graph = network.modules[i].body;
    reached_.push_back(graph.empty() ? std::vector<bool>{} : reach(pan::ModuleId(i), pan::NodeId(0)));
  }
}

std::vector<pan::NodeId> Flow::next(pan::ModuleId module, pan::NodeId id) const {
  const auto& node = network_.modules[module.index()].body[id];
  auto result = node.out;
  if (std::holds_alternative<pan::Complete>(node.content)) return {};
  if (const auto* execute = std::get_if<pan::Execute>(&node.content)) {
    if (!can_end_[execute->module.index()]) return {};
  }
  if (std::holds_alternative<pan::Until>(node.content)) result.push_back(node.mate);
  if (std::holds_alternative<pan::Fork>(node.content) && fork_can_end(module, id))
    result.push_back(node.mate);
  return result;
}

void Flow::visit_forks(pan::ModuleId module) {
  const auto& nodes = network_.modules[module.index()].body.nodes;
  // An inner CONCURRENT stands behind the outer one in the text, and the outer one needs to know about it.
  for (auto i = nodes.size(); i-- > 0;) {
    if (!std::holds_alternative<pan::Fork>(nodes[i].content)) continue;
    const auto can = [&](pan::NodeId first) { return block_can_end(module, first); };
    fork_can_end_[module.index()][i] = std::any_of(nodes[i].out.begin(), nodes[i].out.end(), can);
  }
}

bool Flow::block_can_end(pan::ModuleId module, pan::NodeId first) const {
  return reach(module, first)[block_end(module, first).index()];
}

pan::NodeId Flow::block_end(pan::ModuleId module, pan::NodeId first) const {
  // The first End that is not of a block within this one, counting CONCURRENT and END CONCURRENT in the order
  // of the text.
  const auto& nodes = network_.modules[module.index()].body.nodes;
  int depth = 0;
  auto at = first.index();
  while (depth > 0 || !std::holds_alternative<pan::End>(nodes[at].content)) {
    if (std::holds_alternative<pan::Fork>(nodes[at].content)) ++depth;
    if (std::holds_alternative<pan::Join>(nodes[at].content)) --depth;
    ++at;
  }
  return pan::NodeId(at);
}

std::vector<bool> Flow::reach(pan::ModuleId module, pan::NodeId from) const {
  std::vector<bool> seen(network_.modules[module.index()].body.nodes.size(), false);
  std::vector<pan::NodeId> open{from};
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

bool is_statement(const pan::Content& content) {
  return !std::holds_alternative<pan::Start>(content) && !std::holds_alternative<pan::End>(content) &&
         !std::holds_alternative<pan::Merge>(content) && !std::holds_alternative<pan::Join>(content) &&
         !std::holds_alternative<pan::Until>(content);
}

}  // namespace pal::frontend
