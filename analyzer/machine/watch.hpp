// What one exploration measures.
#pragma once

#include <cstdint>
#include <vector>

#include "analyzer/problem/problem.hpp"

namespace pal::analyzer {

/// A requirement's measure as the machine follows it. Nothing is watched by default.
///
/// Instants that may still count are carried along by threads (age, sample), by conditions and messages. One
/// more is the instant from which the next value is measured: the reference of a reaction, interval, duration
/// or busy period.
struct Watch {
  enum class Kind { nothing, age, response, sample, interval, loss, duration, busy };
  Kind kind = Kind::nothing;
  bool reaction = false;           // age, sample: what is measured is the reaction
  ConditionId condition{};         // age
  Table<ChannelId, bool> events;   // response
  Table<ChannelId, bool> samples;  // sample
  DeviceId device{};               // loss
  int in = 1;                      // loss: the length of the row, at most longest_followed_row
  int code = 0;                    // duration
  ProcessorId processor;           // busy
  bool least = false;              // interval: the least is asked for
  Nanoseconds limit = 0;
  Table<StepId, bool> at;
  Phase phase;  // not limited: the whole run

  /// While something is measured the value grows; a value that is never measured is unbounded.
  bool grows() const {
    return kind == Kind::response || kind == Kind::busy || reaction || (kind == Kind::interval && !least);
  }

  // `counts`: a value that the thread has read can still count. `read_ahead`: a read that can count
  // may follow. `live`: a statement of `at` may follow. Values that cannot count any more are forgotten,
  // which keeps the exploration small.
  Table<StepId, bool> counts;
  Table<StepId, bool> read_ahead;
  Table<StepId, bool> live;
  Table<ChannelId, bool> message_counts;  // sample
  std::uint64_t condition_counts = 0;     // sample: by bit
  Table<KeptId, bool> kept_counts;        // sample: by what modules keep
};

/// `processor`: of a busy period; -1: the first of the requirement.
Watch watch_of(const Problem& problem, const Requirement& requirement, ProcessorId processor = {});

/// Whether a test of `step` looks at `condition`.
bool tests(const Step& step, ConditionId condition);

}  // namespace pal::analyzer
