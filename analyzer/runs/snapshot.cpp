#include "analyzer/runs/snapshot.hpp"

#include <algorithm>

namespace pal::analyzer {

namespace {

std::optional<Snapshot::Timer> known_of(const ConcreteRun& run, std::size_t number) {
  const ConcreteRun::Timer& timer = run.timers()[number];
  if (!timer.active) return std::nullopt;
  Nanoseconds worked = run.worked(static_cast<int>(number), run.now());
  // What may come at any time from now on may do so later, too.
  if (timer.range.worst >= Range::unbounded) worked = std::min(worked, timer.range.best);
  return Snapshot::Timer{timer.range.best, timer.range.worst, worked, timer.frozen};
}

}  // namespace

Snapshot::Snapshot(const ConcreteRun& run) : state_(run.state()) {
  for (std::size_t t = 0; t < run.timers().size(); ++t) timers_.push_back(known_of(run, t));
}

std::size_t hash_of_snapshot(const ConcreteRun& run) {
  std::size_t hash = StateHash()(run.state());
  const auto mix = [&hash](Nanoseconds value) {
    hash ^= static_cast<std::size_t>(value) + 0x9e3779b97f4a7c15U + (hash << 6U) + (hash >> 2U);
  };
  for (std::size_t t = 0; t < run.timers().size(); ++t) {
    const auto timer = known_of(run, t);
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
