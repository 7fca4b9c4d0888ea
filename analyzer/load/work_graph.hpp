// The work of a processor while a skill stays in a recurrence, and the time that must pass meanwhile, as sums
// over cycles.
//
// Each timer that something waits for is given a share of the time. Of each nanosecond in which it runs, that
// share counts for it. Let the shares of timers that run at the same time add up to at most R. Then what all
// of them count in a run is at most R of its time. Now let the work round each cycle be at most what is
// counted for the timers that start there. Then the work is at most R of the time of any unending run: R
// bounds the load.
//
// What is counted at a start must have passed when the timer ends. For a timer that fires this is its best
// time. A timer that is stopped gives back the most that it may have had left. An action of the processor may
// end early, so it is counted with its worst time w, as work and as passing time. If it takes a, then its
// part of the sum is w - share w instead of a - share a. This is not too little, because no share is above 1.
// Time in which an action is interrupted counts for no timer.
//
// This is linear in the shares, so linear programming finds the least R that they prove (share_bound.hpp). It
// does not depend on a common divisor of the times.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "analyzer/load/recurrence.hpp"

namespace pal::analyzer {

/// Time that passes: `time`, counted at the share `share`. Negative: it was counted and did not pass.
struct Passing {
  int share = -1;
  Nanoseconds time = 0;
};

/// A firing. `work`: the greatest time that the processor's actions that begin with it may need. The same
/// time passes for these, at their own shares.
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
  /// Sets of shares of timers that run at the same time, each list in order. No set contains another.
  std::vector<std::vector<int>> together;
};

/// Of `processor` in `recurrence`. A timer has one share for each statement or wait that it measures. Timers
/// that can take no time have none.
WorkGraph work_graph(const Machine& machine, const ZoneGraph& graph, const Recurrence& recurrence,
                     ProcessorId processor);

}  // namespace pal::analyzer
