// What a processor has to do while a skill stays in a recurrence, and what has to pass meanwhile, as sums
// over cycles.
//
// Each timer that something waits for is given a share of the time: as much of each of its nanoseconds as its
// share says counts for it. Where the shares of those that go on at once add up to at most R, what all of
// them count in a run is at most R of its time. So if, round each cycle, the work is at most what the timers
// that start there count, the work is at most R of the time of any unending run: R bounds the load.
//
// What is counted at a start must have passed when the timer ends. Of a timer that fires that is its best
// time; one that is stopped takes back the most that it may have had left. An action of the processor may end
// early: it is counted with its worst time w as work and as what passes. If it takes a, then of a - share a,
// its part of the sum, w - share w is counted; since no share is above 1 that is not too little. Time in
// which an action is interrupted counts for nobody.
//
// This is linear in the shares, so the least R that they prove is found by linear programming
// (share_bound.hpp). Nothing in it depends on what the times have in common.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "analyzer/load/recurrence.hpp"

namespace pal::analyzer {

/// What counts as passing: `time` at the share `share`. Less than nothing: what was counted and did not pass.
struct Passing {
  int share = -1;
  Nanoseconds time = 0;
};

/// A firing. `work`: the greatest that the processor's actions that begin with it may need; of these the same
/// passes, at their own share.
struct WorkEdge {
  int from = -1;
  int to = -1;
  Nanoseconds work = 0;
  std::vector<Passing> passing;
};

struct WorkGraph {
  int nodes = 0;
  std::vector<WorkEdge> edges;
  int shares = 0;
  /// Shares of what goes on at once, each list in order. None lies within another.
  std::vector<std::vector<int>> together;
};

/// Of `processor` in `recurrence`. A timer has one share for each statement or wait that it measures. What
/// can take no time has none.
WorkGraph work_graph(const Machine& machine, const ZoneGraph& graph, const Recurrence& recurrence,
                     int processor);

}  // namespace pal::analyzer
