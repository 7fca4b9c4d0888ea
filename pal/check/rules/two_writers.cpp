// Conditions with two writers, in two modules or in two blocks at once.
#include <map>
#include <set>
#include <vector>

#include "pal/check/rules/blocks.hpp"
#include "pal/check/rules/families.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

using Sets = std::map<pan::ConditionId, SourceSpan>;  // the first SPC of each condition

void check_modules(const pan::Network& network, Diagnostics& diagnostics) {
  std::map<pan::ConditionId, std::pair<pan::ModuleId, SourceSpan>> first;
  std::set<std::pair<pan::ConditionId, pan::ModuleId>> reported;
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    const pan::ModuleId module(i);
    for (const auto& node : network.modules[i].body.nodes) {
      const auto* set = std::get_if<pan::Set>(&node.content);
      if (set == nullptr) continue;
      const auto [entry, fresh] = first.emplace(set->condition, std::pair(module, node.where));
      if (fresh || entry->second.first == module || !reported.emplace(set->condition, module).second)
        continue;
      auto& finding =
          diagnostics.report(Finding::set_by_two, node.where, network.conditions[set->condition.index()].name,
                             network.modules[entry->second.first.index()].name, network.modules[i].name);
      finding.note(entry->second.second, Remark::also_set);
    }
  }
}

void check_writing_blocks(const pan::Network& network, pan::ModuleId module, const pan::Node& fork,
                          Diagnostics& diagnostics) {
  Sets earlier;
  for (std::size_t block = 0; block < fork.out.size(); ++block) {
    Sets sets;
    each_node_of_block(network, module, fork, block, [&sets](const pan::Node& node) {
      if (const auto* set = std::get_if<pan::Set>(&node.content)) sets.emplace(set->condition, node.where);
    });
    for (const auto& [condition, where] : sets) {
      const auto [entry, fresh] = earlier.emplace(condition, where);
      if (fresh) continue;
      auto& finding =
          diagnostics.report(Finding::set_in_two_blocks, where, network.conditions[condition.index()].name);
      finding.note(entry->second, Remark::also_set);
    }
  }
}

}  // namespace

void check_writers(const pan::Network& network, Diagnostics& diagnostics) {
  check_modules(network, diagnostics);
  for (std::size_t i = 0; i < network.modules.size(); ++i) {
    for (const auto& node : network.modules[i].body.nodes) {
      if (std::holds_alternative<pan::Fork>(node.content)) {
        check_writing_blocks(network, pan::ModuleId(i), node, diagnostics);
      }
    }
  }
}

}  // namespace pal::check
