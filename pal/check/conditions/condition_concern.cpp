#include "pal/check/conditions/condition_concern.hpp"

#include <iterator>
#include <variant>
#include <vector>

#include "pal/check/conditions/guards.hpp"

namespace pal::check::conditions {

Concern::Concern(const pan::Network& network, pan::ModuleId root) : network_(network) {
  std::set<pan::ModuleId> entered{root};
  std::vector<pan::ModuleId> open{root};
  while (!open.empty()) {
    const auto module = open.back();
    open.pop_back();
    for (const auto& node : network.modules[module.index()].body.nodes) {
      enter(node.content);
      const auto* execute = std::get_if<pan::Execute>(&node.content);
      if (execute != nullptr && entered.insert(execute->module).second) open.push_back(execute->module);
    }
  }
  for (auto it = own_.begin(); it != own_.end();) it = is_tested(*it) ? std::next(it) : own_.erase(it);
}

void Concern::enter(const pan::Content& content) {
  std::vector<pan::ConditionId> read;
  if (const auto* set = std::get_if<pan::Set>(&content)) own_.insert(set->condition);
  if (const auto* choose = std::get_if<pan::Choose>(&content)) {
    for (const auto& guard : choose->guards) conditions_of(guard, read);
  }
  if (const auto* until = std::get_if<pan::Until>(&content); until != nullptr && until->guard) {
    conditions_of(*until->guard, read);
  }
  tested_.insert(read.begin(), read.end());
}

/// Does reaching the statement at `place` and what it does concern no condition, and is there one way on?
/// Then it is unknown whether a thread is there or already behind it.
bool Concern::is_silent(const Place& place) const {
  const auto& content = node(place).content;
  if (const auto* set = std::get_if<pan::Set>(&content)) return !sets(set->condition);
  if (const auto* read = std::get_if<pan::Read>(&content)) return !is_tested(read->condition);
  if (const auto* until = std::get_if<pan::Until>(&content)) return !until->guard;
  if (const auto* execute = std::get_if<pan::Execute>(&content))
    return network_.modules[execute->module.index()].body.empty();
  const bool matters =
      std::holds_alternative<pan::Complete>(content) || std::holds_alternative<pan::End>(content) ||
      std::holds_alternative<pan::Fork>(content) || std::holds_alternative<pan::Choose>(content);
  return !matters && node(place).out.size() == 1;
}

Place Concern::settled(const Place& from) const {
  Place place = from;
  for (std::size_t steps = network_.modules[from.module.index()].body.nodes.size(); is_silent(place);
       --steps) {
    if (steps == 0) return from;
    const auto& here = node(place);
    const bool goes_back = std::holds_alternative<pan::Until>(here.content);
    place.node = goes_back ? here.mate : here.out.front();
  }
  return place;
}

}  // namespace pal::check::conditions
