#include "analyzer/runs/simulate.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "analyzer/runs/dice.hpp"
#include "analyzer/runs/snapshot.hpp"

namespace pal::analyzer {
namespace {

/// So much happens at one instant only where time stands still.
constexpr std::size_t most_at_once = 20'000;

/// The longest of a device's times.
Nanoseconds longest_of(const Device& device) {
  if (const auto* event = std::get_if<pan::EventDevice>(&device.behaviour)) return event->period.count();
  if (const auto* request = std::get_if<pan::RequestDevice>(&device.behaviour))
    return request->answer.worst.count();
  const auto* frames = std::get_if<pan::FrameDevice>(&device.behaviour);
  return frames == nullptr ? 0 : frames->period.count();
}

/// A sporadic event may wait for ever. Here it waits longer than it must by less than two to the power of
/// this, in nanoseconds. That is 17 s, or more than 32 times the longest time in the problem if that is more.
std::uint64_t bits_of_pause(const Problem& problem) {
  Nanoseconds longest = 0;
  for (const Device& device : problem.devices) longest = std::max(longest, longest_of(device));
  for (const Step& step : problem.steps)
    longest = std::max({longest, step.cost.worst, step.within.value_or(0)});
  constexpr std::uint64_t usual = 34;
  const auto bits = static_cast<std::uint64_t>(std::bit_width(static_cast<std::uint64_t>(longest)));
  return std::max(usual, bits + 5);
}

/// All orders of magnitude are alike.
Nanoseconds sporadic(const Range& range, SimulationOptions::Times times, std::uint64_t bits, Dice& dice) {
  if (times == SimulationOptions::Times::best) return range.best;
  return range.best + static_cast<Nanoseconds>(dice.below(std::uint64_t{1} << dice.below(bits + 1)));
}

Nanoseconds duration(const Range& range, SimulationOptions::Times times, std::uint64_t bits, Dice& dice) {
  if (range.worst >= Range::unbounded) return sporadic(range, times, bits, dice);
  switch (times) {
    case SimulationOptions::Times::worst:
      return range.worst;
    case SimulationOptions::Times::best:
      return range.best;
    case SimulationOptions::Times::extremes:
      return dice.drawn(2) == 0 ? range.best : range.worst;
    case SimulationOptions::Times::random:
      return range.best +
             static_cast<Nanoseconds>(dice.below(static_cast<std::uint64_t>(range.worst - range.best) + 1));
  }
  return range.best;
}

class Run {
 public:
  Run(const Machine& machine, const SimulationOptions& options)
      : machine_(machine),
        options_(options),
        pause_(bits_of_pause(machine.problem())),
        dice_(options.seed, options.seldom),
        concrete_run_(machine, options.record),
        phases_(options.phases) {}

  Simulation make() {
    begin();
    while (made_.script.size() < options_.max_events && !stands_still() && !over() && !stopped() && go_on())
      draw_durations();
    made_.stands = stands_still();
    made_.ended = concrete_run_.state().ended;
    made_.failed = concrete_run_.state().failed;
    made_.measured = concrete_run_.measured();
    for (std::size_t o = 0; o < concrete_run_.births().size(); ++o) {
      if (!grows(concrete_run_.state(), machine_.watch(), static_cast<int>(o))) continue;
      made_.grown = std::max(made_.grown, concrete_run_.now() - concrete_run_.births()[o]);
    }
    if (options_.record) made_.trace = concrete_run_.trace();
    return std::move(made_);
  }

 private:
  bool stands_still() const {
    const std::vector<ScriptedFiring>& fired = made_.script;
    return fired.size() > most_at_once && fired[fired.size() - 1 - most_at_once].at == fired.back().at;
  }
  bool stopped() const { return options_.stop && options_.stop(); }
  bool over() const { return concrete_run_.state().ended || concrete_run_.state().failed; }

  ConcreteRun::Timer& timer(int index) { return concrete_run_.timers()[static_cast<std::size_t>(index)]; }

  void begin() {
    if (options_.beginning.empty()) {
      concrete_run_.begin(dice_);
      note(-1, 0, dice_.take_picks());
      return draw_durations();
    }
    ScriptedChoices first(options_.beginning.front().choices);
    concrete_run_.begin(first);
    note(-1, 0, options_.beginning.front().choices);
    for (std::size_t k = 1; k < options_.beginning.size() && !over(); ++k) {
      if (!follow(options_.beginning[k])) break;
    }
    for (ConcreteRun::Timer& each : concrete_run_.timers()) {
      if (!each.active) continue;
      const Nanoseconds worked = concrete_run_.worked(index_of(each), concrete_run_.now());
      each.duration =
          duration({std::max(each.range.best, worked), each.range.worst}, options_.times, pause_, dice_);
    }
  }

  int index_of(const ConcreteRun::Timer& of) { return static_cast<int>(&of - concrete_run_.timers().data()); }

  /// False: it cannot fire so.
  bool follow(const ScriptedFiring& firing) {
    const ConcreteRun::Timer& fired = timer(firing.timer);
    if (!fired.active || fired.frozen || firing.at < concrete_run_.now()) return false;
    for (const ConcreteRun::Timer& each : concrete_run_.timers()) {
      if (each.active && !each.frozen && concrete_run_.worked(index_of(each), firing.at) > each.range.worst)
        return false;
    }
    if (concrete_run_.worked(firing.timer, firing.at) < fired.range.best) return false;
    ScriptedChoices choices(firing.choices);
    if (!concrete_run_.fire(firing.timer, firing.at, choices)) return false;
    note(firing.timer, firing.at, firing.choices);
    return true;
  }

  void draw_durations() {
    for (int started : concrete_run_.started()) {
      ConcreteRun::Timer& each = timer(started);
      each.duration = duration(each.range, options_.times, pause_, dice_);
      if (const Nanoseconds phase = take_phase(started); phase >= 0)
        each.duration = std::clamp(phase, each.range.best, each.range.worst);
    }
  }

  /// The instant of the first event or frame of the device whose timer it is, the first time; else -1.
  Nanoseconds take_phase(int started) {
    if (started < machine_.first_device_timer() || started == machine_.pause_timer() || phases_.empty())
      return -1;
    const DeviceId device = machine_.device_of(started);
    if (started != machine_.next_timer(device)) return -1;
    return std::exchange(phases_[device], -1);
  }

  /// Fires one of the timers that are due first. False: the run is at its end.
  bool go_on() {
    std::vector<int> first;
    Nanoseconds least = Range::unbounded;
    for (std::size_t t = 0; t < concrete_run_.timers().size(); ++t) {
      const ConcreteRun::Timer& each = concrete_run_.timers()[t];
      if (!each.active || each.frozen) continue;
      const Nanoseconds left = each.duration - concrete_run_.worked(static_cast<int>(t), concrete_run_.now());
      if (left < least) first.clear();
      if (left <= least) first.push_back(static_cast<int>(t));
      least = std::min(least, left);
    }
    const Nanoseconds at = concrete_run_.now() + least;
    if (first.empty() || at > options_.until) {
      made_.end = options_.until;
      made_.still = first.empty();
      return false;
    }
    while (!first.empty()) {
      const auto chosen = first.begin() + dice_.drawn(static_cast<int>(first.size()));
      dice_.take_picks();
      if (concrete_run_.fire(*chosen, at, dice_)) {
        note(*chosen, at, dice_.take_picks());
        return true;
      }
      if (concrete_run_.outgrown()) return false;
      first.erase(chosen);
    }
    return false;
  }

  void note(int fired, Nanoseconds at, std::vector<std::uint8_t> choices) {
    made_.script.push_back({fired, std::move(choices), at});
    made_.measured_after.resize(concrete_run_.measured().size(), made_.script.size());
    if (options_.hash_states) made_.states.push_back(hash_of_snapshot(concrete_run_));
    made_.end = at;
  }

  const Machine& machine_;
  const SimulationOptions& options_;
  std::uint64_t pause_;
  Dice dice_;
  ConcreteRun concrete_run_;
  Table<DeviceId, Nanoseconds> phases_;  // -1: drawn, or over
  Simulation made_;
};

}  // namespace

Simulation simulate(const Machine& machine, const SimulationOptions& options) {
  return Run(machine, options).make();
}

}  // namespace pal::analyzer
