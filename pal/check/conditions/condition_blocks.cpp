#include "pal/check/conditions/condition_blocks.hpp"

#include <map>
#include <utility>
#include <variant>

namespace pal::check::conditions {

namespace {

const pan::Node& node(const pan::Network& network, const Place& place) {
  return network.modules[place.module.index()].body[place.node];
}

bool is_below(const State& state, const Thread& thread, std::int32_t parent) {
  auto number = thread.parent;
  while (number >= 0 && number != parent) number = state.threads[static_cast<std::size_t>(number)].parent;
  return number == parent;
}

/// The parent goes on, without its blocks. Numbers are places in the list; other threads keep their order.
State without_blocks(const pan::Network& network, const Concern& concern, const State& from,
                     std::int32_t parent) {
  State state;
  state.values = from.values;
  std::map<std::int32_t, std::int32_t> renumbered;
  for (const auto& thread : from.threads) {
    if (is_below(from, thread, parent)) continue;
    renumbered[thread.number] = static_cast<std::int32_t>(state.threads.size());
    state.threads.push_back(thread);
  }
  for (auto& thread : state.threads) {
    thread.number = renumbered.at(thread.number);
    if (thread.parent >= 0) thread.parent = renumbered.at(thread.parent);
  }
  auto& owner = state.threads[static_cast<std::size_t>(renumbered.at(parent))];
  owner.waits_for_blocks = false;
  owner.at.node = node(network, owner.at).mate;
  owner.at = concern.settled(owner.at);
  return state;
}

}  // namespace

std::vector<Ending> endings(const pan::Network& network, const Concern& concern, const State& state,
                            std::int32_t parent) {
  std::vector<Ending> result{{without_blocks(network, concern, state, parent), std::nullopt}};
  for (const auto& thread : state.threads) {
    if (!is_below(state, thread, parent) || thread.ended || thread.waits_for_blocks) continue;
    const auto* set = std::get_if<pan::Set>(&node(network, thread.at).content);
    if (set == nullptr || !concern.sets(set->condition)) continue;
    const auto stopped = result;
    for (const bool value : {true, false}) {
      if (set->value && *set->value != value) continue;
      for (auto ending : stopped) {
        ending.state.values[set->condition] = value;
        ending.last = LastSet{thread, *set, value};
        result.push_back(std::move(ending));
      }
    }
  }
  return result;
}

}  // namespace pal::check::conditions
