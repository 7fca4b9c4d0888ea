// A world that somebody looks at while it moves.
#pragma once

#include <functional>
#include <vector>

#include "sim/workcell.hpp"

namespace pal::workcell {

/// Looks without touching: a run is the same with and without.
struct Watcher {
  runtime::Time period{};      // between two looks; the first is at 0
  std::function<void()> look;  // must not throw
};

/// The workcell, halted for a look wherever one is due.
class WatchedWorld final : public runtime::World {
 public:
  WatchedWorld(sim::Workcell& workcell, std::vector<Watcher> watchers);

  void advance_to(runtime::Time when) override;

 private:
  struct Due {
    Watcher watcher;
    runtime::Time next{};
  };
  sim::Workcell& workcell_;
  std::vector<Due> due_;
};

}  // namespace pal::workcell
