#include "programs/workcell/session/watched_world.hpp"

#include <algorithm>

namespace pal::workcell {

WatchedWorld::WatchedWorld(sim::Workcell& workcell, std::vector<Watcher> watchers) : workcell_(workcell) {
  for (Watcher& watcher : watchers) due_.push_back({.watcher = std::move(watcher)});
}

void WatchedWorld::begin(runtime::Time when) {
  for (Due& due : due_) due.next = when;
}

void WatchedWorld::advance_to(runtime::Time when) {
  const auto earlier = [](const Due& a, const Due& b) { return a.next < b.next; };
  for (auto first = std::min_element(due_.begin(), due_.end(), earlier);
       first != due_.end() && first->next <= when;
       first = std::min_element(due_.begin(), due_.end(), earlier)) {
    workcell_.advance_to(first->next);
    first->watcher.look();
    first->next += first->watcher.period;
  }
  workcell_.advance_to(when);
}

}  // namespace pal::workcell
