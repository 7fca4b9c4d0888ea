#include "pal/check/rules/steady_conditions.hpp"

#include <algorithm>
#include <set>

#include "pal/check/conditions/guards.hpp"
#include "pal/check/rules/blocks.hpp"

namespace pal::check {

namespace {

constexpr std::size_t most_known = 8;

}  // namespace

bool SteadyConditions::belongs(pan::ModuleId module, pan::ModuleId outermost) const {
  while (network_->modules[module.index()].executed_by.valid())
    module = network_->modules[module.index()].executed_by;
  return module == outermost;
}

SteadyConditions::SteadyConditions(const pan::Network& network, pan::ModuleId outermost)
    : network_(&network) {
  std::set<pan::ConditionId> set;
  std::set<pan::ConditionId> unsteady;
  std::vector<pan::ConditionId> tested;
  for (std::size_t m = 0; m < network.modules.size(); ++m) {
    const pan::ModuleId module(m);
    const bool own = belongs(module, outermost);
    for (const pan::Node& node : network.modules[m].body.nodes) {
      if (const auto* sets = std::get_if<pan::Set>(&node.content))
        (own ? set : unsteady).insert(sets->condition);
      if (!own) continue;
      if (const auto* read = std::get_if<pan::Read>(&node.content)) unsteady.insert(read->condition);
      if (const auto* choose = std::get_if<pan::Choose>(&node.content)) {
        for (const pan::Guard& guard : choose->guards) conditions::conditions_of(guard, tested);
      }
      const auto* until = std::get_if<pan::Until>(&node.content);
      if (until != nullptr && until->guard) conditions::conditions_of(*until->guard, tested);
      const auto* fork = std::get_if<pan::Fork>(&node.content);
      for (std::size_t block = 0; fork != nullptr && block < node.out.size(); ++block) {
        each_node_of_block(network, module, node, block, [&](const pan::Node& inside) {
          if (const auto* sets = std::get_if<pan::Set>(&inside.content)) unsteady.insert(sets->condition);
        });
      }
    }
  }
  for (const pan::ConditionId condition : tested) {
    if (known_.size() == most_known) return;
    if (set.contains(condition) && !unsteady.contains(condition)) known_.push_back(condition);
  }
}

std::optional<std::size_t> SteadyConditions::bit_of(pan::ConditionId condition) const {
  const auto found = std::find(known_.begin(), known_.end(), condition);
  if (found == known_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - known_.begin());
}

/// Nothing: it depends on what is not known.
std::optional<bool> SteadyConditions::value_of(const pan::Guard& guard, Values values) const {
  using Kind = pan::Guard::Kind;
  if (guard.kind == Kind::equals) {
    const auto bit = bit_of(guard.condition);
    if (!bit) return std::nullopt;
    return ((values >> *bit & 1U) != 0) == guard.value;
  }
  if (guard.kind == Kind::negation) {
    const auto inner = value_of(guard.terms.front(), values);
    return inner ? std::optional(!*inner) : std::nullopt;
  }
  const bool deciding = guard.kind == Kind::any_of;  // one term with this value decides
  bool open = false;
  for (const pan::Guard& term : guard.terms) {
    const auto value = value_of(term, values);
    if (value == deciding) return deciding;
    open = open || !value;
  }
  return open ? std::nullopt : std::optional(!deciding);
}

std::vector<SteadyConditions::Values> SteadyConditions::after(const pan::Node& node, pan::NodeId next,
                                                              Values values) const {
  if (const auto* set = std::get_if<pan::Set>(&node.content)) {
    const auto bit = bit_of(set->condition);
    if (!bit) return {values};
    const Values mask = Values{1} << *bit;
    if (set->value) return {*set->value ? values | mask : values & ~mask};
    return {values | mask, values & ~mask};
  }
  if (const auto* choose = std::get_if<pan::Choose>(&node.content)) {
    for (std::size_t arm = 0; arm < choose->guards.size() && arm < node.out.size(); ++arm) {
      const auto value = value_of(choose->guards[arm], values);
      if (node.out[arm] == next && value != false) return {values};
    }
    const bool is_arm = std::find(node.out.begin(), node.out.end(), next) != node.out.end();
    return is_arm ? std::vector<Values>() : std::vector<Values>{values};
  }
  if (const auto* until = std::get_if<pan::Until>(&node.content); until != nullptr && until->guard) {
    const auto value = value_of(*until->guard, values);
    if (value && *value == (next == node.mate)) return {};
  }
  return {values};
}

}  // namespace pal::check
