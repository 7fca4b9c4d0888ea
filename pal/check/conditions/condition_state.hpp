// The places of a module's threads, as far as conditions are concerned.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <vector>

#include "pal/pan/network.hpp"

namespace pal::check::conditions {

using Values = std::map<pan::ConditionId, bool>;

struct Place {
  pan::ModuleId module;
  pan::NodeId node;
  friend auto operator<=>(const Place&, const Place&) = default;
};

/// A thread: where it is, inside which Executes, and what it has latched. It is also the parent of the blocks
/// that have its number.
struct Thread {
  std::int32_t number = 0;
  std::int32_t parent = -1;
  bool waits_for_blocks = false;
  bool can_end = true;  // of a block
  bool ended = false;
  pan::ModuleId module;      // in whose text it stands,
  std::size_t name = 0;      // and where: index in Module::threads
  std::vector<Place> calls;  // the Executes it is in
  Place at;
  Values latched;

  friend auto operator<=>(const Thread&, const Thread&) = default;
};

struct State {
  std::vector<Thread> threads;  // by number
  Values values;
  friend auto operator<=>(const State&, const State&) = default;
};

}  // namespace pal::check::conditions
