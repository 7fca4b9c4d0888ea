// Traces with the structure of the touch skill in the workcell: ALTER every 28 ms, a sensor that answers in 6
// ms.
#pragma once

#include <cstdint>

#include "pal/trace/trace.hpp"

namespace pal::analyzer::chart {

struct TouchRun {
  bool read_first = false;           // the order of the thesis: read the condition, then wait for the request
  bool no_costs = false;             // every statement takes no time
  std::int64_t tick_ns = 9'300'000;  // the first ALTER event
  std::int64_t end_ns = 60'000'000;
  int percent = 100;  // of each activity's and the sensor's worst time
};

/// Runs it on virtual processors with preemption, priorities and latencies as in workcell.pal.
trace::Trace touch_trace(const TouchRun& run);

/// Of all values of pc-force that a motion was decided on, the one that was oldest at the effect of TXM(
/// motion to MC1 ). Gives the instants of its set and of that effect. {0, 0} if there is none.
struct Oldest {
  std::int64_t set_ns = 0;
  std::int64_t sent_ns = 0;
};
Oldest oldest_force(const trace::Trace& trace);

}  // namespace pal::analyzer::chart
