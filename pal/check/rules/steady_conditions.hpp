// Conditions whose values are known along a way through a module, because no other thread sets them
// meanwhile.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pal/pan/network.hpp"

namespace pal::check {

class SteadyConditions {
 public:
  using Values = std::uint32_t;  // by bit; all are FALSE at the start

  /// None: a test may have either outcome.
  explicit SteadyConditions(const pan::Network& network) : network_(&network) {}

  /// Conditions that a thread sets and tests, with the modules that it executes, and that no block and no
  /// other thread sets. No RPC latches them. If there are more than eight, the first eight.
  SteadyConditions(const pan::Network& network, pan::ModuleId outermost);

  bool none() const { return known_.empty(); }

  /// The possible values at `next`, which follows `node`, after `values` before `node`. Empty: a way with
  /// these values does not go there.
  std::vector<Values> after(const pan::Node& node, pan::NodeId next, Values values) const;

 private:
  bool belongs(pan::ModuleId module, pan::ModuleId outermost) const;
  std::optional<std::size_t> bit_of(pan::ConditionId condition) const;
  std::optional<bool> value_of(const pan::Guard& guard, Values values) const;

  const pan::Network* network_;
  std::vector<pan::ConditionId> known_;  // by bit
};

}  // namespace pal::check
