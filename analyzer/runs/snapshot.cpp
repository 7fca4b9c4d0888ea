#include "analyzer/runs/snapshot.hpp"

#include <algorithm>

namespace pal::analyzer {

Snapshot::Snapshot(const ConcreteRun& run) : state_(run.state()) {
  for (std::size_t t = 0; t < run.timers().size(); ++t) {
    const ConcreteRun::Timer& timer = run.timers()[t];
    auto& known = timers_.emplace_back();
    if (!timer.active) continue;
    Nanoseconds worked = run.worked(static_cast<int>(t), run.now());
    // What may come at any time from now on may do so later, too.
    if (timer.range.worst >= Range::unbounded) worked = std::min(worked, timer.range.best);
    known = {timer.range.best, timer.range.worst, worked, timer.frozen};
  }
}

std::size_t Snapshot::hash() const {
  std::size_t hash = StateHash()(state_);
  const auto mix = [&hash](Nanoseconds value) {
    hash ^= static_cast<std::size_t>(value) + 0x9e3779b97f4a7c15U + (hash << 6U) + (hash >> 2U);
  };
  for (const auto& timer : timers_) {
    mix(timer ? 1 : 0);
    if (!timer) continue;
    mix(std::get<0>(*timer));
    mix(std::get<1>(*timer));
    mix(std::get<2>(*timer));
    mix(std::get<3>(*timer) ? 1 : 0);
  }
  return hash;
}

}  // namespace pal::analyzer
