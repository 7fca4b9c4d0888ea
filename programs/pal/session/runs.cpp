#include "programs/pal/session/runs.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <variant>

#include "analyzer/runs/witness.hpp"

namespace pal::program {
namespace {

const analyzer::Watch nothing;

/// The firings of a script by the timers' numbers; nothing if it names a timer that there is not.
std::optional<std::vector<analyzer::ScriptedFiring>> script_of(
    const analyzer::Machine& machine, const std::vector<analyzer::run_checker::Firing>& firings) {
  std::map<std::string, int> timers{{"", -1}};
  for (int timer = 0; timer < machine.timer_count(); ++timer) timers[machine.timer_name(timer)] = timer;
  std::vector<analyzer::ScriptedFiring> script;
  for (const auto& firing : firings) {
    const auto timer = timers.find(firing.timer);
    if (timer == timers.end() || (timer->second < 0) != script.empty()) return std::nullopt;
    script.push_back({timer->second, firing.choices, firing.at});
  }
  if (script.empty()) return std::nullopt;
  return script;
}

bool completes(const trace::Trace& run) {
  return std::any_of(run.events.begin(), run.events.end(),
                     [](const trace::Event& event) { return event.kind == trace::Kind::complete; });
}

/// Between two events or frames of a device that sends or collects by itself in step; else 0.
analyzer::Nanoseconds period_of(const analyzer::Device& device) {
  if (const auto* event = std::get_if<pan::EventDevice>(&device.behaviour))
    return event->sporadic ? 0 : event->period.count();
  const auto* frames = std::get_if<pan::FrameDevice>(&device.behaviour);
  return frames == nullptr ? 0 : frames->period.count();
}

/// By device: how long after its opening its first event or frame comes, of those that are in step; else -1.
/// A phase that the environment gives counts all the same.
Table<analyzer::DeviceId, analyzer::Nanoseconds> drawn_phases(const analyzer::Problem& problem,
                                                              std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  Table<analyzer::DeviceId, analyzer::Nanoseconds> phases;
  for (const analyzer::Device& device : problem.devices) {
    const auto period = static_cast<std::uint64_t>(period_of(device));
    phases.push_back(period == 0 ? -1 : static_cast<analyzer::Nanoseconds>(engine() % (period + 1)));
  }
  return phases;
}

}  // namespace

Runs runs_by_chance(const analyzer::Problem& problem, const analyzer::SimulationOptions& options,
                    std::size_t count) {
  Runs runs;
  for (std::size_t n = 0; n < count; ++n) runs.names.push_back("seed " + std::to_string(options.seed + n));
  runs.make = [&problem, options](std::size_t number) {
    const analyzer::Machine machine(problem, nothing);
    analyzer::SimulationOptions one = options;
    one.seed += number;
    // Phases are no times that are at one end: with all of those at one end there are as many of these.
    using Times = analyzer::SimulationOptions::Times;
    if (one.times == Times::worst || one.times == Times::best) one.phases = drawn_phases(problem, one.seed);
    analyzer::Simulation made = analyzer::simulate(machine, one);
    made.trace.origin = "simulated";
    return std::optional(KnownRun{std::move(made.trace), made.end, made.ended, made.still, made.stands});
  };
  return runs;
}

Runs scripted_runs(const analyzer::Problem& problem,
                   const std::vector<analyzer::run_checker::FiledWitness>& witnesses) {
  Runs runs;
  for (const auto& witness : witnesses) runs.names.push_back("the script of " + witness.requirement);
  runs.make = [&problem, &witnesses](std::size_t number) -> std::optional<KnownRun> {
    const auto& witness = witnesses[number];
    const analyzer::Machine machine(problem, nothing);
    const auto script = script_of(machine, witness.script);
    if (!script) return std::nullopt;
    auto made = analyzer::replay(machine, *script);
    if (!made) return std::nullopt;
    made->trace.origin = "simulated";
    const bool completed = completes(made->trace);
    return KnownRun{std::move(made->trace), witness.grows ? witness.at : script->back().at, completed,
                    made->still, false};
  };
  return runs;
}

}  // namespace pal::program
