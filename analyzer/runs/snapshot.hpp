// All that the future of a run depends on, at one instant.
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "analyzer/runs/concrete_run.hpp"

namespace pal::analyzer {

/// Two runs with the same snapshot can go on in the same ways. When things that are measured began is not in
/// it.
class Snapshot {
 public:
  explicit Snapshot(const ConcreteRun& run);

  friend bool operator==(const Snapshot&, const Snapshot&) = default;

  /// Best and worst time, what is done of it, and whether it is frozen.
  using Timer = std::tuple<Nanoseconds, Nanoseconds, Nanoseconds, bool>;

 private:
  State state_;
  std::vector<std::optional<Timer>> timers_;
};

/// The same for runs with the same snapshot. No snapshot is made for it.
std::size_t hash_of_snapshot(const ConcreteRun& run);

}  // namespace pal::analyzer
