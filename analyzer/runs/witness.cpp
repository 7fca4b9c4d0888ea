#include "analyzer/runs/witness.hpp"

#include <algorithm>

#include "analyzer/runs/path_schedule.hpp"

namespace pal::analyzer {
namespace {

std::vector<ScriptedFiring> path_to(const ZoneGraph& graph, const Peak& peak) {
  std::vector<ScriptedFiring> path{{peak.timer, peak.choices, 0}};
  for (int at = peak.parent; at >= 0;) {
    const ZoneClass& of = graph.classes()[static_cast<std::size_t>(at)];
    const Move& move = graph.move_to(of);
    path.push_back({move.timer, move.choices, 0});
    at = of.parent;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<ScriptedFiring> path_to(const ZoneGraph& graph, int target) {
  const ZoneClass& of = graph.classes()[static_cast<std::size_t>(target)];
  Peak last;
  last.parent = of.parent;
  last.timer = graph.move_to(of).timer;
  last.choices = graph.move_to(of).choices;
  return path_to(graph, last);
}

WitnessSearch search_of(const Peak& peak, const std::function<bool()>& stop) {
  WitnessSearch search;
  search.measured = peak.value >= 0;
  search.growing = peak.grows ? peak.measured : no_growth;
  search.stop = stop;
  return search;
}

}  // namespace

std::optional<std::vector<ScriptedFiring>> script_to(const Machine& machine, const ZoneGraph& graph,
                                                     int target,
                                                     const std::vector<std::pair<int, Nanoseconds>>& left) {
  std::vector<ScriptedFiring> path = path_to(graph, target);
  PathSchedule schedule(machine, path, PathSchedule::Pin::worst);
  for (const auto& [timer, time] : left) schedule.leave(timer, time);
  if (!schedule.feasible()) return std::nullopt;
  const auto times = schedule.solve(PathSchedule::Aim::any);
  if (!times) return std::nullopt;
  for (std::size_t k = 0; k < path.size(); ++k) path[k].at = (*times)[k];
  return path;
}

std::optional<Witness> replay(const Machine& machine, const std::vector<ScriptedFiring>& script,
                              bool growing) {
  ConcreteRun concrete_run(machine);
  for (std::size_t k = 0; k < script.size(); ++k) {
    ScriptedChoices choices(script[k].choices);
    if (k == 0) {
      concrete_run.begin(choices);
      continue;
    }
    const Nanoseconds at = script[k].at;
    if (at < concrete_run.now()) return std::nullopt;
    const auto& timers = concrete_run.timers();
    for (std::size_t t = 0; t < timers.size(); ++t) {
      if (!timers[t].active || timers[t].frozen) continue;
      if (concrete_run.worked(static_cast<int>(t), at) > timers[t].range.worst) return std::nullopt;
    }
    const auto& fired = timers[static_cast<std::size_t>(script[k].timer)];
    if (!fired.active || fired.frozen || concrete_run.worked(script[k].timer, at) < fired.range.best)
      return std::nullopt;
    if (!concrete_run.fire(script[k].timer, at, choices)) return std::nullopt;
  }
  Witness witness;
  witness.script = script;
  witness.trace = concrete_run.trace();
  witness.failed = concrete_run.state().failed;
  const auto& left = concrete_run.timers();
  witness.still = std::none_of(left.begin(), left.end(),
                               [](const ConcreteRun::Timer& timer) { return timer.active && !timer.frozen; });
  const bool least = machine.watch().least;
  bool any = false;
  for (const Measurement& made : concrete_run.measured()) {
    if (growing || made.at != concrete_run.now()) continue;
    if (!any || (least ? made.value <= witness.measured.value : made.value >= witness.measured.value)) {
      witness.measured = made;
    }
    any = true;
  }
  // What still grows counts from the first of the instants that do.
  for (std::size_t o = 0; o < concrete_run.births().size() && !any; ++o) {
    if (!grows(concrete_run.state(), machine.watch(), static_cast<int>(o))) continue;
    const Nanoseconds born = concrete_run.births()[o];
    witness.measured = {concrete_run.now() - born, born, concrete_run.now(), {}};
    witness.grows = true;
    break;
  }
  return witness;
}

std::optional<Witness> stuck_witness(const Machine& machine, const ZoneGraph& graph, int stuck,
                                     Nanoseconds value) {
  const auto script = script_to(machine, graph, stuck, {});
  std::optional<Witness> made;
  if (script) made = replay(machine, *script, true);
  if (!made || !made->grows) return std::nullopt;
  made->measured.value = std::max(made->measured.value, value);
  made->measured.at = made->measured.born + made->measured.value;
  return made;
}

std::optional<Witness> grown_witness(const Machine& machine, const ZoneGraph& graph, int target,
                                     const std::function<bool()>& stop) {
  WitnessSearch search;
  search.growing = oldest_growth;
  search.enough = machine.watch().limit + 1;
  search.stop = stop;
  return witness_along(machine, path_to(graph, target), search);
}

std::optional<Witness> witness_along(const Machine& machine, std::vector<ScriptedFiring> path,
                                     const WitnessSearch& search) {
  const Watch& watch = machine.watch();
  const bool timed = search.measured && watch.kind != Watch::Kind::loss;
  const PathSchedule::Aim aim = !timed        ? PathSchedule::Aim::any
                                : watch.least ? PathSchedule::Aim::least
                                              : PathSchedule::Aim::greatest;
  const auto further = [&watch](Nanoseconds a, Nanoseconds b) { return watch.least ? a < b : a > b; };
  std::optional<Witness> best;
  // With times fixed where preemption makes sums of them; if there are such, with what all can be at once.
  for (const PathSchedule::Pin pin :
       {PathSchedule::Pin::worst, PathSchedule::Pin::open, PathSchedule::Pin::best}) {
    PathSchedule schedule(machine, path, pin, search.growing);
    if (!schedule.feasible()) continue;
    const auto times =
        schedule.solve(aim, search.enough.value_or(Range::unbounded), search.stop, search.less_will_not_do);
    if (!times) continue;
    for (std::size_t k = 0; k < path.size(); ++k) path[k].at = (*times)[k];
    std::optional<Witness> made = replay(machine, path, search.growing != no_growth);
    if (!made) continue;
    if (!best || further(made->measured.value, best->measured.value)) best = std::move(made);
    const bool attained = search.enough && !further(*search.enough, best->measured.value);
    if (!schedule.pinned() || search.quick || attained) break;
  }
  return best;
}

std::optional<Witness> witness_of(const Machine& machine, const ZoneGraph& graph, const Peak& peak,
                                  const std::function<bool()>& stop) {
  WitnessSearch search = search_of(peak, stop);
  if (peak.grows) search.enough = machine.watch().limit + 1;
  if (!peak.grows && peak.value >= 0) search.enough = peak.value;
  return witness_along(machine, path_to(graph, peak), search);
}

std::optional<Witness> breaking_witness_of(const Machine& machine, const ZoneGraph& graph, const Peak& peak,
                                           Nanoseconds limit, bool quick, const std::function<bool()>& stop) {
  WitnessSearch search = search_of(peak, stop);
  search.quick = quick;
  search.enough = machine.watch().least ? limit - 1 : limit + 1;
  search.less_will_not_do = true;
  return witness_along(machine, path_to(graph, peak), search);
}

}  // namespace pal::analyzer
