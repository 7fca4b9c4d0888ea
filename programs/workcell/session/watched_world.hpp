// A world that is observed while it moves.
#pragma once

#include <functional>
#include <vector>

#include "sim/workcell.hpp"

namespace pal::workcell {

/// Observes without changing anything: a run is the same with and without it.
struct Watcher {
  runtime::Time period{};      // between two looks; the first is at the beginning
  std::function<void()> look;  // must not throw
};

/// The workcell, halted for a look wherever one is due.
class WatchedWorld final : public runtime::World {
 public:
  WatchedWorld(sim::Workcell& workcell, std::vector<Watcher> watchers);

  /// The watchers observe from this future instant on, and not before.
  void begin(runtime::Time when);
  void advance_to(runtime::Time when) override;

 private:
  struct Due {
    Watcher watcher;
    runtime::Time next = runtime::Time::max();
  };
  sim::Workcell& workcell_;
  std::vector<Due> due_;
};

}  // namespace pal::workcell
