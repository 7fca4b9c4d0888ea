// Writes down what happens in a run, without allocating.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "pal/runtime/device.hpp"
#include "pal/runtime/outcome.hpp"
#include "pal/runtime/wiring.hpp"
#include "runtime/trace/trace.hpp"

namespace pal::runtime {

/// Actors of the trace are the wiring's threads, then its devices; statements, channels and conditions are
/// the wiring's.
class Recorder {
 public:
  /// Makes room for `capacity` events, at least one; a whole trace with more of them takes memory while the
  /// run goes on.
  Recorder(const Wiring& wiring, TraceMode mode, std::size_t capacity);

  void add(Time time, trace::Kind kind, int actor, int statement, int subject = -1, std::int32_t value = 0) {
    if (mode_ == TraceMode::none) return;
    const trace::Event event{time.count(), kind, actor, statement, subject, value};
    if (mode_ == TraceMode::all || trace_.events.size() < capacity_) {
      trace_.events.push_back(event);
    } else {
      trace_.events[oldest_] = event;
      oldest_ = oldest_ + 1 == capacity_ ? 0 : oldest_ + 1;
    }
  }
  void add_fault(Time time, int actor, int statement, const std::string& reason);

  trace::Trace take();

 private:
  TraceMode mode_;
  std::size_t capacity_;
  std::size_t oldest_ = 0;  // of the last ones, once there are as many as are kept
  trace::Trace trace_;
};

}  // namespace pal::runtime
