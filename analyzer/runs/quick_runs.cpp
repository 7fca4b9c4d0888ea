#include "analyzer/runs/quick_runs.hpp"

#include <algorithm>

#include "analyzer/machine/machine.hpp"
#include "analyzer/runs/simulate.hpp"

namespace pal::analyzer {
namespace {

using Measure = Requirement::Measure;

constexpr std::uint64_t runs = 6;
constexpr std::uint64_t extreme_runs = 300;
constexpr std::uint64_t steady_runs = 20;
constexpr std::size_t few_events = 1'500;
constexpr std::size_t many_events = 50'000;

/// SimulationOptions::seldom of steady runs: most loops go round dozens of times.
constexpr std::uint64_t seldom_in_steady_runs = 64;

/// A run with times at their extremes is as long as pal simulate makes it.
constexpr Nanoseconds usual_length = 10'000'000'000;

using Times = SimulationOptions::Times;

Simulation run_by_chance(const Machine& machine, std::uint64_t seed, std::size_t events,
                         const std::function<bool()>& stop) {
  SimulationOptions how;
  how.seed = seed;
  how.until = Range::unbounded;
  how.max_events = events;
  how.stop = stop;
  how.record = false;
  return simulate(machine, how);
}

Simulation long_run(const Machine& machine, Times times, std::uint64_t seldom, std::uint64_t seed,
                    std::size_t events, const std::function<bool()>& stop) {
  SimulationOptions how;
  how.times = times;
  how.seed = seed;
  how.seldom = seldom;
  how.until = usual_length;
  how.max_events = events;
  how.stop = stop;
  how.record = false;
  return simulate(machine, how);
}

/// The run that pal simulate makes of this seed, unless it has more events.
Simulation run_of_extremes(const Machine& machine, std::uint64_t seed, std::size_t events,
                           const std::function<bool()>& stop) {
  return long_run(machine, Times::extremes, SimulationOptions().seldom, seed, events, stop);
}

/// A run in which loops go on for long. So the phases of devices that drift meet in many ways in one run.
Simulation steady_run(const Machine& machine, std::uint64_t seed, std::size_t events,
                      const std::function<bool()>& stop) {
  const Times times = seed % 2 == 1 ? Times::worst : Times::extremes;
  return long_run(machine, times, seldom_in_steady_runs, seed, events, stop);
}

/// The first value that is measured beyond the limit.
auto first_beyond(const Requirement& requirement, const Simulation& run) {
  return std::find_if(run.measured.begin(), run.measured.end(), [&requirement](const Measurement& made) {
    return requirement.allowed().broken_by(made.value);
  });
}

Break break_in(const Requirement& requirement, const Simulation& run) {
  if (run.failed || first_beyond(requirement, run) != run.measured.end()) return Break::measured;
  // What keeps a processor busy counts however the run goes on, if it goes on.
  const bool grown = requirement.measure == Measure::busy && run.grown > requirement.limit;
  return grown ? Break::grown : Break::none;
}

/// Those that have to be watched one by one; none: none is. Nothing: there is nothing to look at.
std::vector<ProcessorId> processors_of(const Problem& problem, const Requirement& requirement) {
  if (!fits_simulation(problem)) return {};
  if (requirement.measure == Measure::load || requirement.measure == Measure::loss) return {};
  if (requirement.measure != Measure::busy) return {ProcessorId{}};
  return requirement.processors;
}

/// A few short runs. Where more is to be done than there is time, also a long run, in which the backlog adds
/// up. Such a skill has very many states.
Break simulated_break(const Problem& problem, const Requirement& requirement, ProcessorId processor,
                      const std::function<bool()>& stop) {
  const Watch watch = watch_of(problem, requirement, processor);
  const Machine machine(problem, watch);
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    const Break found = break_in(requirement, run_by_chance(machine, seed, few_events, stop));
    if (found != Break::none) return found;
  }
  if (problem.overloaded.empty()) return Break::none;
  return break_in(requirement, run_by_chance(machine, 1, many_events, stop));
}

/// The run up to where it breaks the requirement.
std::optional<Witness> witness_of(const Requirement& requirement, const Machine& machine, Simulation run) {
  const auto beyond = first_beyond(requirement, run);
  if (beyond != run.measured.end())
    run.script.resize(run.measured_after[static_cast<std::size_t>(beyond - run.measured.begin())]);
  auto made = replay(machine, run.script);
  const bool breaks = made && (made->failed || requirement.allowed().broken_by(made->measured.value));
  return breaks ? std::move(made) : std::nullopt;
}

}  // namespace

Break simulated_break(const Problem& problem, const Requirement& requirement,
                      const std::function<bool()>& stop) {
  for (const ProcessorId processor : processors_of(problem, requirement)) {
    const Break found = simulated_break(problem, requirement, processor, stop);
    if (found != Break::none) return found;
  }
  return Break::none;
}

std::size_t events_for(std::size_t classes) {
  constexpr std::size_t usual = 150'000, per_class = 50;
  return classes < usual / per_class ? classes * per_class : usual;
}

std::optional<Witness> simulated_witness(const Problem& problem, const Requirement& requirement,
                                         const std::function<bool()>& stop, std::size_t events) {
  std::size_t left = events;
  for (const ProcessorId processor : processors_of(problem, requirement)) {
    const Watch watch = watch_of(problem, requirement, processor);
    const Machine machine(problem, watch);
    for (std::uint64_t number = 1; number <= runs + extreme_runs && left > 0; ++number) {
      if (stop && stop()) return std::nullopt;
      Simulation run = number <= runs
                           ? run_by_chance(machine, number, few_events, stop)
                           : run_of_extremes(machine, number - runs, std::min(left, many_events), stop);
      left -= std::min(left, run.script.size());
      if (break_in(requirement, run) == Break::none) continue;
      return witness_of(requirement, machine, std::move(run));
    }
    left = events / 2;
    for (std::uint64_t number = 1; number <= steady_runs && left > 0; ++number) {
      if (stop && stop()) return std::nullopt;
      Simulation run = steady_run(machine, number, std::min(left, many_events), stop);
      left -= std::min(left, run.script.size());
      if (break_in(requirement, run) == Break::none) continue;
      return witness_of(requirement, machine, std::move(run));
    }
  }
  return std::nullopt;
}

}  // namespace pal::analyzer
