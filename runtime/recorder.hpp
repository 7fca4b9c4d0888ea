// Writes down what happens in a run, without allocating.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "runtime/device.hpp"
#include "runtime/trace/trace.hpp"
#include "runtime/wiring.hpp"

namespace pal::runtime {

/// Actors of the trace are the wiring's threads, then its devices; statements, channels and conditions are
/// the wiring's.
class Recorder {
 public:
  /// Makes room for `capacity` events; a run with more of them takes memory while it runs.
  Recorder(const Wiring& wiring, std::size_t capacity);

  void add(Time time, trace::Kind kind, int actor, int statement, int subject = -1, std::int32_t value = 0) {
    trace_.events.push_back({time.count(), kind, actor, statement, subject, value});
  }
  void add_fault(Time time, int actor, int statement, const std::string& reason);

  trace::Trace take() { return std::move(trace_); }

 private:
  trace::Trace trace_;
};

}  // namespace pal::runtime
