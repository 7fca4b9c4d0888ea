// The interface between the common part of all runs (operations, mail, conditions, blocks) and the part that
// gives them time and processors.
#pragma once

#include <cstdint>
#include <functional>

#include "pal/runtime/wiring.hpp"

namespace pal::runtime {

class Thread;

/// An instant of a run, counted from the start of the skill. Things that happen together happen at one
/// instant.
struct Clock {
  Time now{};
};

/// An event that the kernel asks for.
struct Due {
  enum class Kind : std::uint8_t { message_available, wait_expired, request_arrives };
  Kind kind = Kind::message_available;
  std::int32_t subject = 0;  // channel, thread, channel
};

/// Names a request for an event; 0: none. Numbers are never used again, so cancelling too late does no harm.
struct Ticket {
  std::uint64_t number = 0;
};

/// Gives threads their processors, and lets events happen at their instants: it calls the Kernel's functions
/// for executives (kernel.hpp). An executive of virtual time decides how long everything takes; one of real
/// time measures it.
class Executive {
 public:
  /// Moves the clock, which outlives it.
  explicit Executive(Clock& clock) : clock_(clock) {}
  Executive(const Executive&) = delete;
  Executive& operator=(const Executive&) = delete;
  virtual ~Executive() = default;

  Time now() const { return clock_.now; }

  /// How long a message is on its way.
  virtual Time latency(const Interval& interval) = 0;

  /// The thread has come to a statement that needs its processor, for a time within `time`. When it has had
  /// that time, the kernel's finish() is called.
  virtual void need_processor(Thread& thread, const Interval& time) = 0;
  /// The thread blocks or ends: its processor is free for others.
  virtual void leave(Thread& thread) = 0;

  /// Lets `due` happen at instant `when`, or as soon as possible if that is over. In order of time; events of
  /// one instant in the order in which they were asked for.
  virtual Ticket at(Time when, Due due) = 0;
  /// The same for an action of a device.
  virtual Ticket at(Time when, int device, std::function<void()> action) = 0;
  /// The event will not happen. If it has happened, nothing changes.
  virtual void cancel(Ticket ticket) = 0;

  /// Calls the action of a device as soon as possible. From any thread; all other functions only from within
  /// the run.
  virtual void post(int device, std::function<void()> action) = 0;

 protected:
  void set(Time now) { clock_.now = now; }

 private:
  Clock& clock_;
};

}  // namespace pal::runtime
