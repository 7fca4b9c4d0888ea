// When everything that a source causes is done, at the earliest and at the latest.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "analyzer/compositional/causes/thread_behaviour.hpp"
#include "analyzer/compositional/times/busy_window.hpp"

namespace pal::analyzer::compositional {

/// Times count from the nominal instant of the occurrence of the node's source; for the start of a module
/// from time 0. `never`: unbounded.
struct NodeTimes {
  Nanoseconds earliest = 0;  // release
  Nanoseconds latest = 0;    // release
  Nanoseconds finish = 0;    // of the whole segment
  std::vector<Nanoseconds>
      effects;  // latest effect of each of the segment's steps that anything depends on, else `unknown`
  std::vector<Nanoseconds> worked;    // the same without the time that a send is blocked on its slot
  std::vector<Nanoseconds> arrivals;  // latest arrival at each of the segment's waits
  static constexpr Nanoseconds unknown = -1;
};

/// What determines an instant: the instant of what is waited for, plus `after`.
struct Due {
  enum class By {
    source,   // the nominal instant of its source
    held,     // its thread was blocked in the last send of the previous job
    idle,     // its thread is idle for the first time
    arrival,  // `node` arrives at the wait or CONCURRENT `step`
    blocks,   // the blocks that `node` has started at `step` are over
    message,  // `node` has sent by `step`
    put,      // `node` has reached the put of `step`, or is blocked on its slot
  };
  Nanoseconds at = 0;  // `never`: no bound
  By by = By::source;
  NodeId node{};
  StepId step{};
  Nanoseconds after = 0;
};

class Interference;

struct Times {
  Table<NodeId, NodeTimes> nodes;
  /// The same counted from the event itself, which may come after its nominal instant; of what no event
  /// brings about they are those of `nodes`.
  Table<NodeId, NodeTimes> since_event;
  /// By thread: why its times are unbounded; empty if they are bounded.
  Table<ThreadId, Why> unbounded_reason;
  Table<ThreadId, bool> blocked;  // by thread: it may be blocked in a send
  /// By source: each event is received before the next can come.
  Table<SourceId, bool> no_overrun;
  /// By source: greatest inter-arrival time, and latest first occurrence after time 0; `never`: unbounded.
  Table<SourceId, Due> longest_gap;
  Table<SourceId, Due> first;
  std::shared_ptr<const Interference> interference;  // with the jitter found
  bool interrupted = false;
};

/// `at`: further steps whose times are needed.
Times times_of(const Problem& problem, const Forest& forest, const ThreadBehaviours& behaviours,
               const Table<StepId, bool>& at, const std::function<bool()>& stop,
               WindowEnds ends = WindowEnds::closed);

/// Whether the effects of a step are timed whoever asks for them.
bool is_always_timed(const Step& step);

/// Where a segment has a step; the number of its steps: it has not.
std::size_t place_of(const Segment& segment, StepId step);

/// Latest effect of `step` in a node; `never` if there is no bound, or it is not one of its steps.
Nanoseconds latest_effect(const Forest& forest, const Table<NodeId, NodeTimes>& nodes, NodeId node,
                          StepId step);
/// And its earliest.
Nanoseconds earliest_effect(const Forest& forest, const Times& times, NodeId node, StepId step);

}  // namespace pal::analyzer::compositional
