// How near the skills that run come to their requirements: measured beside the run, in a thread of its own.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "pal/runtime/skill.hpp"
#include "pal/runtime/trace_ring.hpp"
#include "server/knowledge.hpp"

namespace pal::workcell {

/// The run puts its events into a ring, and never waits. What finds no room there ends the measuring of that
/// run, since a gap would show times that were not.
class MarginMeter {
 public:
  /// The knowledge outlives it.
  explicit MarginMeter(server::Knowledge& knowledge);
  ~MarginMeter();
  MarginMeter(const MarginMeter&) = delete;
  MarginMeter& operator=(const MarginMeter&) = delete;

  /// The skill, which outlives the run, is about to run. Where its run puts its events; null: it has no
  /// requirement that a run shows.
  runtime::TraceRing* begin(const runtime::Skill& skill);
  /// Its run is over.
  void end();

 private:
  struct Run;
  void work();
  void take_what_is_there();
  void tell();

  server::Knowledge& knowledge_;
  runtime::TraceRing ring_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::unique_ptr<Run> run_;  // null: nothing runs
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace pal::workcell
