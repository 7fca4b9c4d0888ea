// Writes down what happens in a run, without allocating.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "pal/runtime/device.hpp"
#include "pal/runtime/outcome.hpp"
#include "pal/runtime/wiring.hpp"
#include "pal/trace/spool.hpp"
#include "pal/trace/trace.hpp"

namespace pal::runtime {

/// Actors of the trace are the wiring's threads, then its devices; statements, channels and conditions are
/// the wiring's.
class Recorder {
 public:
  /// Makes room for `capacity` events, at least one; a whole trace with more of them takes memory while the
  /// run goes on.
  /// With a `spool`, which outlives the recorder, a whole trace goes there, `capacity` events at a time.
  Recorder(const Wiring& wiring, TraceMode mode, std::size_t capacity, trace::EventSpool* spool = nullptr);

  /// The place of the next event, valid until the next call. Fill in all its members, one by one. (Copying an
  /// event that was just made takes longer, because the copy waits for its parts.)
  trace::Event& next() {
    if (!has_room()) make_room();
    return *next_++;
  }
  bool has_room() const { return next_ != end_; }
  /// For one event or more.
  void make_room();
  /// Indices of the text, for the events that name it.
  std::int32_t add_promise(const std::string& promise) {
    trace_.promises.push_back(promise);
    return static_cast<std::int32_t>(trace_.promises.size()) - 1;
  }
  std::int32_t add_fault(const std::string& reason) {
    trace_.faults.push_back(reason);
    return static_cast<std::int32_t>(trace_.faults.size()) - 1;
  }

  /// Actors, statements, channels and conditions.
  const trace::Trace& tables() const { return trace_; }

  trace::Trace take();

 private:
  TraceMode mode_;
  trace::EventSpool* spool_;  // null: none
  std::size_t capacity_;
  trace::Event *next_ = nullptr, *end_ = nullptr;  // the room
  bool has_all_ = false;  // of the last ones: as many as are kept; the oldest is at next_
  trace::Event unkept_;
  trace::Trace trace_;
};

}  // namespace pal::runtime
