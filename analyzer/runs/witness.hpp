// From a path through the zone graph to a run with whole times, which is replayed to confirm it.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "analyzer/runs/concrete_run.hpp"
#include "analyzer/zones/zone_graph.hpp"
#include "runtime/trace/trace.hpp"

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

/// A run to the class `target` of `graph`. Nothing, if there is none along the class's path.
std::optional<std::vector<ScriptedFiring>> script_to(const Machine& machine, const ZoneGraph& graph,
                                                     int target);

/// A run to class `stuck` of `graph`, in which nothing happens any more while the watched value grows. It
/// lasts until the value is `value`.
std::optional<Witness> stuck_witness(const Machine& machine, const ZoneGraph& graph, int stuck,
                                     Nanoseconds value);

/// A run to class `target` of `graph`, in which the watched value grows: at its end the oldest such value is
/// greater than the limit.
std::optional<Witness> grown_witness(const Machine& machine, const ZoneGraph& graph, int target,
                                     const std::function<bool()>& stop);

/// Of a path, what grows at its end: nothing that is asked for; or the first of the values that do.
constexpr int no_growth = -1;
constexpr int oldest_growth = -2;

/// The run that fires as `path` does, at other times, in which the value measured at its end is greatest (or
/// least, if that is watched). Any times, if nothing is `measured`. `growing`: the observer whose value is
/// asked for instead, or oldest_growth. Nothing if there is none, or none was confirmed by replay. The path
/// may come from another problem. `quick`: where actions without a fixed time preempt others, they take their
/// worst time, and no other times are tried. The same holds once `stop`, if given, returns true, and where
/// the value `known`, which no run exceeds, is attained in this way.
std::optional<Witness> witness_along(const Machine& machine, std::vector<ScriptedFiring> path, bool measured,
                                     int growing = no_growth, bool quick = false,
                                     const std::function<bool()>& stop = {},
                                     std::optional<Nanoseconds> known = {});

/// The run along the path to `peak` in which the measured value is greatest (or least, if that is watched).
/// Nothing if none was confirmed by replay.
std::optional<Witness> witness_of(const Machine& machine, const ZoneGraph& graph, const Peak& peak,
                                  bool quick = false, const std::function<bool()>& stop = {});

}  // namespace pal::analyzer
