// The outside of a driver, as the runtime sees it: named ports for typed messages.
//
// A device knows nothing of the skill. Before anything runs, the skill's wiring and the device's ports are
// matched by name, and field by field, units included.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "pal/runtime/in_use.hpp"
#include "pal/runtime/payload.hpp"

namespace pal::runtime {

/// An instant or a length of time; instants count from the start of the run.
using Time = std::chrono::nanoseconds;

/// One field of a message; all payloads are flat lists of numbers (payload.hpp). {"x", "mm"}; {"x", "mm",
/// FieldKind::number, 255}; {"location", "", FieldKind::text}.
struct FieldSpec {
  std::string name;
  std::string unit;  // canonical spelling, as in PAL; empty: a plain number
  FieldKind kind = FieldKind::number;
  std::size_t count = 1;  // of values: the size of an array

  friend bool operator==(const FieldSpec&, const FieldSpec&) = default;
};

/// A message that goes to or comes from a device. A request ("request wrench") has no fields.
struct PortSpec {
  std::string message;
  bool to_device = false;
  std::vector<FieldSpec> fields;

  friend bool operator==(const PortSpec&, const PortSpec&) = default;
};

/// The functions of the runtime for an attached device. Valid from attach() to the end of the run; for
/// another run the device is attached again.
class DeviceHost {
 public:
  virtual ~DeviceHost() = default;

  virtual Time now() const = 0;

  /// Names one action that was asked for. Numbers are never used again, so cancelling twice, or too late,
  /// does no harm.
  struct Appointment {
    std::uint32_t slot = 0;
    std::uint64_t order = 0;  // 0: no action
  };

  /// Calls `action` at instant `when` (>= now). Actions at one instant run in the order in which they were
  /// asked for.
  virtual Appointment at(Time when, std::function<void()> action) = 0;

  /// The action will not be called, and the run does not wait for its instant. If it has been called, nothing
  /// happens.
  virtual void cancel(Appointment appointment) = 0;

  /// Puts a message from the device's port `port` (index into ports()) into the skill's channel. False: the
  /// slot was full, the message is lost and the run is marked with an overrun.
  virtual bool deliver(std::size_t port, std::span<const double> fields) = 0;

  /// Names a request that the device was handed; 0: none. Numbers are never used again in a run.
  using Request = std::uint64_t;
  /// Inside Device::receive(): the request that is handed over.
  virtual Request request() const { return 0; }

  /// As deliver(), for a device that knows which request it answers. Requests before that one, which have no
  /// answer yet, will have none. The answer to a request that is open no more is noted as a broken promise,
  /// and is lost. deliver() answers the oldest request that is open. It passes over one that was withdrawn
  /// and is late, as soon as a younger one may be answered.
  virtual bool answer([[maybe_unused]] Request request, std::size_t port, std::span<const double> fields) {
    return deliver(port, fields);
  }
  /// The oldest open request whose answer would come at the port will have none (ON REQUEST … OR NEVER; of
  /// any other device that breaks its promise).
  virtual void leave_unanswered([[maybe_unused]] std::size_t port) {}

  /// Marks the device busy or idle in the trace. Becoming busy takes the oldest request that the device has
  /// received and not yet taken out of its slot. Marking it busy once more takes the next one (a frame
  /// answers all of them). A device that never marks itself busy takes a request when it answers it.
  virtual void mark_busy(bool busy) = 0;

  /// Ends the skill with its error completion; `reason` goes into the result and the trace.
  virtual void fault(std::string reason) = 0;

  /// Calls `action` as soon as possible. A thread of the device's own may call this function and no other,
  /// until the device is closed. The action then uses the other functions.
  virtual void post(std::function<void()> action) { at(now(), std::move(action)); }
};

class Device {
 public:
  virtual ~Device() = default;

  virtual const std::string& name() const = 0;
  virtual const std::vector<PortSpec>& ports() const = 0;

  /// Called once, before each run.
  virtual void attach(DeviceHost& host) = 0;

  /// The skill waits for this device, or sends to it, for the first time in this run. For a device that sends
  /// events, only the first wait counts.
  virtual void open() = 0;

  /// A message for port `port`. Called at the instant at which it arrives.
  virtual void receive(std::size_t port, std::span<const double> fields) = 0;

  /// A request for port `port` that the device was given and has not taken yet (mark_busy) is withdrawn.
  /// True: the device forgets it. False: the device will answer it nevertheless, and the runtime discards the
  /// answer.
  virtual bool withdraw([[maybe_unused]] std::size_t port) { return false; }

  /// The skill is over, however it ended. The device leaves its machine standing still.
  virtual void close() = 0;

  /// Whether a run uses it; for the dispatcher.
  InUse& in_use() { return in_use_; }

 private:
  InUse in_use_;
};

/// What moves while the skill runs: a physics engine, or nothing.
class World {
 public:
  virtual ~World() = default;

  /// Advances the world to instant `when` (never back in time). Called before anything happens at `when`.
  /// Whatever the world does by itself up to then happens in this call. It may deliver messages by the
  /// DeviceHosts, whose clock is at `when` already.
  virtual void advance_to(Time when) = 0;

  /// The next instant at which something happens in the world by itself: bytes arrive, a conversion ends. A
  /// run stops there on its way.
  virtual Time next_event() { return Time::max(); }

  /// Waits until the world's own time has reached `when`; in virtual time it returns at once. If something
  /// came in from outside meanwhile, it returns that earlier instant, and the run goes there first.
  virtual Time wait_until(Time when) { return when; }

  /// In real time the world is advanced at least this often, whatever happens. max(): only for events; and if
  /// it has none when the run begins, never.
  virtual Time beat() { return std::chrono::milliseconds(10); }

  /// In real time: whether one thread moves the world without the kernel's lock. Such a world and the run
  /// reach each other by DeviceHost::post and by wake() alone. Its devices never wait for each other's
  /// threads. wait_until() then waits for the wall clock.
  virtual bool apart() const { return false; }
  /// Something is to be done in the world before the instant that wait_until() waits for: it returns soon.
  /// From any thread; only of a world that is apart.
  virtual void wake() {}

  /// The run was held from outside and goes on; what passed meanwhile in the world's own time does not count.
  virtual void resumed() {}

  /// Whether a run uses it; for the dispatcher.
  InUse& in_use() { return in_use_; }

 private:
  InUse in_use_;
};

}  // namespace pal::runtime
