// The seam between what is common to all runs (operations, mail, conditions, blocks) and what gives them
// time and processors.
#pragma once

#include <cstdint>
#include <functional>

#include "pal/runtime/wiring.hpp"

namespace pal::runtime {

class Thread;

/// The instant of a run, from the start of the skill. All that happens together happens at one instant.
struct Clock {
  Time now{};
};

/// What the kernel wants to happen at an instant.
struct Due {
  enum class Kind : std::uint8_t { message_available, wait_expired, request_arrives };
  Kind kind = Kind::message_available;
  std::int32_t subject = 0;  // channel, thread, channel
};

/// Names what was asked for; 0: nothing. Never used again, so that cancelling too late does no harm.
struct Ticket {
  std::uint64_t number = 0;
};

/// Gives threads their processors, and lets things happen at their instants: it calls the Kernel's functions
/// for executives (kernel.hpp). An executive of virtual time decides how long everything takes; one of real
/// time finds out.
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
  /// it, the kernel's finish() is called.
  virtual void need_processor(Thread& thread, const Interval& time) = 0;
  /// The thread blocks or ends: its processor is free for others.
  virtual void leave(Thread& thread) = 0;

  /// `due` at instant `when`, or as soon as it is over. In order of time; of one instant in the order in
  /// which they were asked for.
  virtual Ticket at(Time when, Due due) = 0;
  /// Likewise an action of a device.
  virtual Ticket at(Time when, int device, std::function<void()> action) = 0;
  /// It will not happen. Nothing changes if it has.
  virtual void cancel(Ticket ticket) = 0;

  /// The action of a device happens as soon as possible. From any thread; all others from within the run
  /// only.
  virtual void post(int device, std::function<void()> action) = 0;

 protected:
  void set(Time now) { clock_.now = now; }

 private:
  Clock& clock_;
};

}  // namespace pal::runtime
