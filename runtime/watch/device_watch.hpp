// Whether a device keeps the times that the environment declares for it (docs/reference/execution-model.md,
// Devices).
#pragma once

#include "pal/runtime/wiring.hpp"

namespace pal::runtime {

/// What was seen of a promise; `measured` is the time that the promise limits.
struct Seen {
  enum class What { kept, sooner, later };
  What what = What::kept;
  Time measured{};
  bool noted = false;  // that it is late was seen before, when it was overdue
};

class DeviceWatch {
 public:
  DeviceWatch() = default;
  explicit DeviceWatch(const DeviceTimes& times) : times_(times) {}

  /// A thread waits for its events for the first time.
  void opened(Time now);
  /// A request has come to it.
  void asked(Time now);
  /// It has forgotten a request that was withdrawn; `busy`: with another one.
  void forgotten(Time now, bool busy);

  /// It has sent a message that was not requested.
  Seen event(Time now);
  /// It has answered the request that came at `asked`.
  Seen answered(Time now, Time asked);

  /// From this instant on it is late. Time::max(): it has nothing to do, or it was already reported as late.
  Time due() const { return due_; }
  /// The instant has come.
  Seen overdue(Time now);

  /// Whether it has a request that it has not answered.
  bool is_asked() const { return asked_ > 0; }

  const DeviceTimes& times() const { return times_; }

 private:
  using Behaviour = DeviceTimes::Behaviour;
  bool sends_events() const {
    return times_.behaviour == Behaviour::events || times_.behaviour == Behaviour::sporadic;
  }
  void expect_event(Time from, Time to);
  void expect_answer(Time since);

  DeviceTimes times_;
  Time due_ = Time::max();
  bool late_ = false;
  // Events: the next one is due within [from_, to_]; it comes up to a jitter later.
  bool open_ = false;
  Time from_{};
  Time to_ = Time::max();
  Time last_{};  // event, or answer
  // Requests: how many it has, and since when it may be at work on one.
  int asked_ = 0;
  Time since_{};
};

}  // namespace pal::runtime
