// The events of a run, line by line, while it goes on.
#pragma once

#include <atomic>
#include <fstream>
#include <string>
#include <thread>

#include "pal/runtime/outcome.hpp"
#include "pal/runtime/trace_ring.hpp"

namespace pal::workcell {

/// Writes to a file, or to a pipe that a viewer reads, in a thread of its own. The run never waits for it
/// (docs/reference/trace.md, "While a run goes on").
class LiveTrace {
 public:
  /// Opens the file; of a named pipe that waits for a reader. Throws std::runtime_error if it cannot.
  LiveTrace(const std::string& file, const runtime::Wiring& wiring, std::size_t capacity = 1U << 16U);
  LiveTrace(const LiveTrace&) = delete;
  LiveTrace& operator=(const LiveTrace&) = delete;
  ~LiveTrace();

  runtime::TraceRing& ring() { return ring_; }
  /// The run is over: writes what is left, and the end. False: not everything could be written.
  bool end(const runtime::Outcome& outcome);
  std::uint64_t dropped() const { return ring_.dropped(); }

 private:
  void write();
  void write_what_is_there();
  void stop();

  runtime::TraceRing ring_;
  std::ofstream out_;
  std::string first_, last_;  // lines
  std::atomic<bool> over_ = false;
  std::thread writer_;
};

}  // namespace pal::workcell
