#include "analyzer/runs/run_search.hpp"

#include <algorithm>
#include <random>
#include <set>

#include "analyzer/runs/simulate.hpp"

namespace pal::analyzer {
namespace {

using Times = SimulationOptions::Times;

/// Instants of the best run that one device is tried at in a turn.
constexpr std::size_t most_instants = 12;

/// SimulationOptions::seldom of steady runs.
constexpr std::uint64_t once_in = 16;

/// Runs in which nothing is measured are followed by a few that are longer.
constexpr std::size_t longer = 32;
constexpr std::size_t long_runs = 4;

/// Of more events the times are not chosen again.
constexpr std::size_t most_timed = 1'000;

/// For a sporadic event that is not wanted: after all that matters.
constexpr Nanoseconds late = 1'000'000'000'000'000;

class RunSearch {
 public:
  RunSearch(const Machine& machine, const RunSearchOptions& options)
      : machine_(machine),
        options_(options),
        events_(options.max_events),
        phases_(machine.problem().devices.size(), -1) {}

  std::optional<Witness> run() {
    draw(0, options_.drawn, 0);
    if (!best_) draw_long();
    if (!breaks()) draw(options_.drawn, options_.steady, once_in);
    while (!done() && align()) {
    }
    return std::move(best_);
  }

 private:
  bool done() {
    if (runs_ >= options_.runs || (options_.stop && options_.stop())) return true;
    if (!best_) return false;
    return best_->failed || (options_.bound && best_->measured.value == *options_.bound);
  }

  bool further(Nanoseconds value, Nanoseconds than) const {
    return machine_.watch().least ? value < than : value > than;
  }

  bool breaks() const {
    return best_ && (best_->failed || further(best_->measured.value, machine_.watch().limit));
  }

  /// Runs by chance, with worst times first; every second goes on from some instant of the best one so far.
  void draw(std::size_t first, std::size_t count, std::uint64_t seldom) {
    constexpr Times times[] = {Times::worst, Times::worst, Times::extremes, Times::random};
    for (std::size_t number = first; number < first + count && !done(); ++number) {
      if (seldom > 0 && breaks()) return;
      SimulationOptions how = usual();
      how.times = times[number / 2 % 4];
      how.seed = number + 1;
      how.seldom = seldom;
      if (best_ && number % 2 == 1 && best_->script.size() > 2) {
        how.beginning = best_->script;
        how.beginning.resize(1 + engine_() % (best_->script.size() - 1));
        how.max_events += how.beginning.size();
      }
      attempt(how);
    }
  }

  /// What is measured may come late in a skill's life, as its completion does.
  void draw_long() {
    events_ *= longer;
    draw(0, long_runs, 0);
    events_ = options_.max_events;
  }

  /// Tries each device with an event or frame at the instants at which something happened while the greatest
  /// value grew. False: nothing became worse by that.
  bool align() {
    if (!best_ || best_->failed) return false;
    bool worse = false;
    for (const DeviceId device : phases_.ids()) {
      if (done()) break;
      const Nanoseconds period = period_of(machine_.problem().devices[device]);
      if (period <= 0) continue;
      fix_phases();
      for (const Nanoseconds instant : instants()) {
        if (done()) break;
        SimulationOptions how = usual();
        how.times = Times::worst;
        how.phases = phases_;
        how.phases[device] = instant % period;
        how.seed = runs_ % 2 == 0 ? seed_ : 1 + runs_ % 5;
        how.seldom = seldom_;
        worse = attempt(how) || worse;
      }
    }
    return worse;
  }

  /// Of a device that sends or collects by itself; else 0.
  static Nanoseconds period_of(const Device& device) {
    if (const auto* event = std::get_if<pan::EventDevice>(&device.behaviour))
      return event->sporadic ? 0 : event->period.count();
    if (const auto* frames = std::get_if<pan::FrameDevice>(&device.behaviour)) return frames->period.count();
    return 0;
  }

  /// The phases that the best run has; what is sporadic and has not come does not come.
  void fix_phases() {
    Table<DeviceId, Nanoseconds> first(phases_.size(), -1);
    for (const ScriptedFiring& firing : best_->script) {
      for (const DeviceId device : first.ids()) {
        if (firing.timer == machine_.next_timer(device) && first[device] < 0) first[device] = firing.at;
      }
    }
    for (const DeviceId device : first.ids()) {
      const auto* event = std::get_if<pan::EventDevice>(&machine_.problem().devices[device].behaviour);
      if (event != nullptr && event->sporadic && first[device] < 0) first[device] = late;
    }
    phases_ = std::move(first);
  }

  std::vector<Nanoseconds> instants() const {
    std::set<Nanoseconds> all;
    for (const ScriptedFiring& firing : best_->script) {
      if (firing.at >= best_->measured.born && firing.at <= best_->measured.at) all.insert(firing.at);
    }
    std::vector<Nanoseconds> made(all.begin(), all.end());
    if (made.size() <= most_instants) return made;
    std::vector<Nanoseconds> some;
    for (std::size_t i = 0; i < most_instants; ++i) some.push_back(made[i * made.size() / most_instants]);
    return some;
  }

  SimulationOptions usual() const {
    SimulationOptions how;
    how.until = Range::unbounded;
    how.max_events = events_;
    how.record = false;
    return how;
  }

  /// Whether the run is worse than the best one.
  bool attempt(const SimulationOptions& how) {
    ++runs_;
    const bool worse = look_at(simulate(machine_, how));
    if (worse) {
      seed_ = how.seed;
      seldom_ = how.seldom;
    }
    return worse;
  }

  bool look_at(const Simulation& made) {
    if (made.failed) {
      auto failing = replay(machine_, made.script);
      if (!failing || !failing->failed) return false;
      best_ = std::move(failing);
      return true;
    }
    if (made.measured.empty()) return false;
    const auto worst = std::max_element(
        made.measured.begin(), made.measured.end(),
        [&](const Measurement& a, const Measurement& b) { return further(b.value, a.value); });
    std::vector<ScriptedFiring> path = made.script;
    path.resize(made.measured_after[static_cast<std::size_t>(worst - made.measured.begin())]);
    const bool worse = keep(replay(machine_, path));
    // Whose events come in this order, but at other times, may be worse still.
    const bool promising = !best_ || worse || 4 * worst->value > 3 * best_->measured.value;
    if (!promising || path.size() > most_timed) return worse;
    WitnessSearch search;
    search.quick = true;
    search.stop = options_.stop;
    return keep(witness_along(machine_, std::move(path), search)) || worse;
  }

  bool keep(std::optional<Witness> found) {
    if (!found || found->grows || found->failed || found->measured.at != found->script.back().at)
      return false;
    if (best_ && !further(found->measured.value, best_->measured.value)) return false;
    best_ = std::move(found);
    return true;
  }

  const Machine& machine_;
  const RunSearchOptions& options_;
  std::size_t events_;  // of each run
  std::mt19937_64 engine_{1};
  std::size_t runs_ = 0;
  std::uint64_t seed_ = 1;               // of the best run
  std::uint64_t seldom_ = 0;             // the same
  Table<DeviceId, Nanoseconds> phases_;  // -1: any
  std::optional<Witness> best_;
};

}  // namespace

std::optional<Witness> search_runs(const Problem& problem, const Requirement& requirement,
                                   const RunSearchOptions& options) {
  if (!fits_simulation(problem) || requirement.measure == Requirement::Measure::load) return std::nullopt;
  std::optional<Witness> worst;
  const bool busy = requirement.measure == Requirement::Measure::busy;
  for (const ProcessorId processor :
       busy ? requirement.processors : std::vector<ProcessorId>{ProcessorId{}}) {
    const Watch watch = watch_of(problem, requirement, processor);
    const Machine machine(problem, watch);
    auto found = RunSearch(machine, options).run();
    if (!found) continue;
    const bool more =
        !worst || found->failed || requirement.allowed().worse(found->measured.value, worst->measured.value);
    if (more && !(worst && worst->failed)) worst = std::move(found);
  }
  return worst;
}

}  // namespace pal::analyzer
