#include "analyzer/verdict/taken_as_lost.hpp"

#include <algorithm>

#include "analyzer/machine/machine.hpp"
#include "analyzer/runs/simulate.hpp"
#include "analyzer/slice/cone.hpp"

namespace pal::analyzer {
namespace {

using Measure = Requirement::Measure;
using Times = SimulationOptions::Times;

constexpr int row = 10;

/// All runs together have at most so many events, however many devices there are.
constexpr std::size_t most_events = 60'000;
constexpr std::size_t events_of_a_run = 1'500;
constexpr std::uint64_t most_runs = 6;

bool is_limited(const Problem& problem, DeviceId device) {
  return std::any_of(problem.requirements.begin(), problem.requirements.end(), [&](const Requirement& each) {
    return each.measure == Measure::loss && each.device == device;
  });
}

/// The greatest number that gets lost in a row, in a few runs with long times in which loops go on.
int lost_of(const Problem& problem, DeviceId device, std::uint64_t runs, const std::function<bool()>& stop) {
  Requirement losses;
  losses.measure = Measure::loss;
  losses.device = device;
  losses.in = row;
  const Watch watch = watch_of(problem, losses);
  const Machine machine(problem, watch);
  Nanoseconds most = 0;
  for (std::uint64_t run = 0; run < runs && !(stop && stop()); ++run) {
    SimulationOptions how;
    how.times = run % 3 == 2 ? Times::extremes : Times::worst;
    how.seed = run + 1;
    how.seldom = run == 0 ? 0 : 64;
    how.until = Range::unbounded;
    how.max_events = events_of_a_run;
    how.stop = stop;
    how.record = false;
    for (const Measurement& made : simulate(machine, how).measured) most = std::max(most, made.value);
  }
  return static_cast<int>(most);
}

/// The threads that wait for the device's events.
bool is_taken_in(const Problem& problem, const Cone& cone, ChannelId event) {
  for (const ThreadId t : problem.threads.ids()) {
    if (!cone.threads[t] || problem.threads[t].module != problem.channels[event].receiver_module) continue;
    return true;
  }
  return false;
}

}  // namespace

std::vector<LostEvents> lost_events(const Problem& problem, const Table<DeviceId, bool>& never_lost,
                                    const std::function<bool()>& stop) {
  std::vector<DeviceId> open;
  for (const DeviceId d : problem.devices.ids()) {
    const Device& device = problem.devices[d];
    if (!std::holds_alternative<pan::EventDevice>(device.behaviour) || !device.event.valid()) continue;
    if (never_lost.contains(d) && never_lost[d]) continue;
    if (!is_limited(problem, d)) open.push_back(d);
  }
  std::vector<LostEvents> found;
  if (open.empty() || !fits_simulation(problem)) return found;
  const std::uint64_t runs =
      std::clamp<std::uint64_t>(most_events / events_of_a_run / open.size(), 1, most_runs);
  for (const DeviceId d : open) {
    const int lost = lost_of(problem, d, runs, stop);
    if (lost > 0) found.push_back({d, lost, row});
  }
  return found;
}

void set_taken_as_lost(const Problem& problem, const std::vector<LostEvents>& lost,
                       std::vector<Verdict>& verdicts) {
  if (lost.empty()) return;
  for (std::size_t r = 0; r < verdicts.size(); ++r) {
    if (verdicts[r].state != VerdictState::holds) continue;
    const Requirement& requirement = problem.requirements[r];
    const Cone cone = cone_of(problem, requirement);
    for (const LostEvents& each : lost) {
      const ChannelId event = problem.devices[each.device].event;
      const bool own = requirement.device == each.device || requirement.is_event(event);
      if (!own && is_taken_in(problem, cone, event)) verdicts[r].taken_as_lost.push_back(each);
    }
  }
}

}  // namespace pal::analyzer
