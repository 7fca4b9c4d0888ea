// Which statements of a module, and of those that it executes, set, read or test conditions.
#pragma once

#include <set>

#include "pal/check/conditions/condition_state.hpp"
#include "pal/pan/network.hpp"

namespace pal::check::conditions {

class Concern {
 public:
  /// `root` is not executed by another module. Conditions that no guard reads are ignored.
  Concern(const pan::Network& network, pan::ModuleId root);

  /// Conditions that a guard reads and that these modules set.
  const std::set<pan::ConditionId>& own() const { return own_; }
  bool sets(pan::ConditionId condition) const { return own_.contains(condition); }
  /// Some guard reads it.
  bool is_tested(pan::ConditionId condition) const { return tested_.contains(condition); }

  /// The next place from here with such a statement; this one if the thread goes round for ever without one.
  Place settled(const Place& from) const;

 private:
  void enter(const pan::Content& content);
  bool is_silent(const Place& place) const;
  const pan::Node& node(const Place& place) const {
    return network_.modules[place.module.index()].body[place.node];
  }

  const pan::Network& network_;
  std::set<pan::ConditionId> own_;
  std::set<pan::ConditionId> tested_;
};

}  // namespace pal::check::conditions
