#include "analyzer/simulate.hpp"

#include <algorithm>
#include <random>

namespace pal::analyzer {
namespace {

class Dice final : public Choices {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  int pick(int n) override { return static_cast<int>(below(static_cast<std::uint64_t>(n))); }
  std::uint64_t below(std::uint64_t n) { return engine_() % n; }

 private:
  std::mt19937_64 engine_;
};

Nanoseconds duration(const Range& range, SimulationOptions::Times times, Dice& dice) {
  // A sporadic event may wait for ever; here it comes within twice its separation.
  const Nanoseconds worst = range.worst >= Range::unbounded ? 2 * range.best + 1'000'000 : range.worst;
  switch (times) {
    case SimulationOptions::Times::worst:
      return range.worst >= Range::unbounded ? range.best : worst;
    case SimulationOptions::Times::best:
      return range.best;
    case SimulationOptions::Times::extremes:
      return dice.pick(2) == 0 ? range.best : worst;
    case SimulationOptions::Times::random:
      return range.best +
             static_cast<Nanoseconds>(dice.below(static_cast<std::uint64_t>(worst - range.best) + 1));
  }
  return range.best;
}

}  // namespace

Simulation simulate(const Machine& machine, const SimulationOptions& options) {
  Dice dice(options.seed);
  Clockwork clockwork(machine, options.record);
  clockwork.begin(dice);
  Simulation made;
  for (std::size_t events = 0; events < options.max_events; ++events) {
    for (int timer : clockwork.started()) {
      Clockwork::Timer& started = clockwork.timers()[static_cast<std::size_t>(timer)];
      started.duration = duration(started.range, options.times, dice);
    }
    made.end = clockwork.now();
    if (clockwork.state().ended || clockwork.state().failed) break;
    std::vector<int> first;
    Nanoseconds least = Range::unbounded;
    for (std::size_t t = 0; t < clockwork.timers().size(); ++t) {
      const Clockwork::Timer& timer = clockwork.timers()[t];
      if (!timer.active || timer.frozen) continue;
      const Nanoseconds left = timer.duration - clockwork.worked(static_cast<int>(t), clockwork.now());
      if (left < least) first.clear();
      if (left <= least) first.push_back(static_cast<int>(t));
      least = std::min(least, left);
    }
    const Nanoseconds at = clockwork.now() + least;
    if (first.empty() || at > options.until) {
      made.end = options.until;
      break;
    }
    bool fired = false;
    while (!fired && !first.empty()) {
      const auto chosen = first.begin() + dice.pick(static_cast<int>(first.size()));
      fired = clockwork.fire(*chosen, at, dice);
      if (!fired) first.erase(chosen);
    }
    if (!fired) break;
  }
  made.ended = clockwork.state().ended;
  made.failed = clockwork.state().failed;
  made.measured = clockwork.measured();
  for (std::size_t o = 0; o < clockwork.births().size(); ++o) {
    if (!grows(clockwork.state(), machine.watch(), static_cast<int>(o))) continue;
    made.grown = std::max(made.grown, clockwork.now() - clockwork.births()[o]);
  }
  if (options.record) made.trace = clockwork.trace();
  return made;
}

}  // namespace pal::analyzer
