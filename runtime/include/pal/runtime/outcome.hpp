// The options of a run, and its outcome.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pal/runtime/broken_promise.hpp"
#include "pal/runtime/cost_policy.hpp"
#include "pal/runtime/device.hpp"
#include "pal/runtime/margins.hpp"
#include "pal/runtime/observer.hpp"
#include "pal/runtime/real_time.hpp"
#include "pal/runtime/run_control.hpp"
#include "pal/runtime/trace_ring.hpp"
#include "pal/trace/spool.hpp"
#include "pal/trace/trace.hpp"

namespace pal::runtime {

/// Which events of a run are kept. Faults are, always.
enum class TraceMode {
  all,
  last,  // the last `trace_capacity` events
  none
};

/// What to do when a promise of the environment is broken, or a requirement fails. Both are always noted.
enum class OnBrokenPromise {
  report,       // the skill goes on
  contingency,  // the skill is told; it is stopped if nothing in it has an answer
  stop          // the skill ends with its error completion
};

struct RunOptions {
  CostPolicy costs = CostPolicy::worst;
  std::uint64_t seed = 0;                   // of CostPolicy::random
  Time horizon = std::chrono::minutes(10);  // a run that is longer ends with its error completion
  TraceMode trace = TraceMode::all;
  std::size_t trace_capacity = 1U << 16U;  // events; a whole trace that is longer takes memory during the run
  /// Takes the events of a whole trace as they come; Outcome::trace then has none. Not in real time, where
  /// the disk would hold up the kernel. Outlives the run; null: none.
  trace::EventSpool* spool = nullptr;
  TraceRing* live = nullptr;            // gets all events as they happen; outlives the run; null: none
  RunControl* control = nullptr;        // outlives the run; null: none
  MessageObserver* observer = nullptr;  // outlives the run; null: none
  WorkObserver* work = nullptr;         // likewise
  /// Gets how near the run comes to each requirement of the skill, while it goes on. Has as many places as
  /// the wiring has requirements, and outlives the run; null: none.
  Margins* margins = nullptr;
  std::optional<RealTime> real_time{};  // by the wall clock; nothing: in virtual time
  OnBrokenPromise on_broken_promise = OnBrokenPromise::report;
  std::vector<SlowStatement> slow{};  // of virtual time: to see what comes of it
};

/// How near a run came to a requirement.
struct MeasuredRequirement {
  std::string name;
  BrokenPromise::Unit unit = BrokenPromise::Unit::time;
  Time least{}, most = Time::max();  // its limits
  std::optional<Time> worst;  // the longest; the shortest, of one with a limit only from below; nothing:
                              // the run had none
};

struct Outcome {
  int code = 0;        // completion code
  bool fault = false;  // the runtime ended the skill: `code` is the error completion
  std::string reason;  // the completion's description, or what the fault was
  Time duration{};     // from the start of the skill to its completion
  std::size_t overruns = 0;
  std::vector<BrokenPromise> broken_promises;     // in the order in which they were broken first
  std::vector<MeasuredRequirement> requirements;  // all of the skill
  trace::Trace trace;
  std::optional<RealTimeReport> real_time{};  // of a run in real time that has begun
};

}  // namespace pal::runtime
