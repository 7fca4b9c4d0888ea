// From a path through the zone graph to a run with whole times, which is replayed to confirm it.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "analyzer/runs/concrete_run.hpp"
#include "analyzer/runs/path_schedule.hpp"
#include "analyzer/zones/zone_graph.hpp"
#include "pal/trace/trace.hpp"

namespace pal::analyzer {

/// A run that can be replayed step by step, and what it shows.
struct Witness {
  std::vector<ScriptedFiring> script;
  trace::Trace trace;
  Measurement measured;  // value, born, at, step
  bool failed = false;   // the run ends with an event that has no response
  bool grows =
      false;  // nothing is measured: the value has grown so far at the end of the run, and still does
  bool still = false;  // nothing happens after the end, ever
};

/// Runs `script` in the concrete domain. Nothing if some timer would fire too early, too late or in the wrong
/// state. `growing`: the value asked for is one that has not been measured at the end.
std::optional<Witness> replay(const Machine& machine, const std::vector<ScriptedFiring>& script,
                              bool growing = false);

/// A run to the class `target` of `graph` at whose end the timers given have exactly that much time left.
/// Nothing, if there is none along the class's path.
std::optional<std::vector<ScriptedFiring>> script_to(const Machine& machine, const ZoneGraph& graph,
                                                     int target,
                                                     const std::vector<std::pair<int, Nanoseconds>>& left);

/// A run to class `stuck` of `graph`, in which nothing happens any more while the watched value grows. It
/// lasts until the value is `value`.
std::optional<Witness> stuck_witness(const Machine& machine, const ZoneGraph& graph, int stuck,
                                     Nanoseconds value);

/// A run to class `target` of `graph`, in which the watched value grows: at its end the oldest such value is
/// greater than the limit.
std::optional<Witness> grown_witness(const Machine& machine, const ZoneGraph& graph, int target,
                                     const std::function<bool()>& stop);

/// Which times of a path are looked for, and how long.
struct WitnessSearch {
  /// The value measured at the end is to be the greatest (or least, if that is watched). False: any times do.
  bool measured = true;
  /// Instead of what is measured: the observer whose value is asked for, or oldest_growth.
  int growing = no_growth;
  /// Actions without a fixed time that preempt others take their worst time, and no other times are tried.
  bool quick = false;
  /// A value as far as this will do: no run goes beyond it, or more is not asked for.
  std::optional<Nanoseconds> enough = {};
  /// Nothing short of `enough` is of use, so that the search ends when it cannot be attained.
  bool less_will_not_do = false;
  /// Once it returns true the search goes on as if it were `quick`.
  std::function<bool()> stop = {};
};

/// The run that fires as `path` does, at other times. Nothing if there is none, or none was confirmed by
/// replay. The path may come from another problem.
std::optional<Witness> witness_along(const Machine& machine, std::vector<ScriptedFiring> path,
                                     const WitnessSearch& search);

/// The run along the path to `peak` in which the measured value is greatest (or least, if that is watched).
/// Nothing if none was confirmed by replay.
std::optional<Witness> witness_of(const Machine& machine, const ZoneGraph& graph, const Peak& peak,
                                  const std::function<bool()>& stop = {});

/// Some run along the path to `peak` in which the watched value breaks `limit`: it is greater (or less, if
/// the least is watched). What does not break it may be returned as well. `quick` as in WitnessSearch.
std::optional<Witness> breaking_witness_of(const Machine& machine, const ZoneGraph& graph, const Peak& peak,
                                           Nanoseconds limit, bool quick,
                                           const std::function<bool()>& stop = {});

}  // namespace pal::analyzer
