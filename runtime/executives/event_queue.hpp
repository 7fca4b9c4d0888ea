// Future events in order of time; events of one instant in the order in which they were asked for.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "pal/runtime/device.hpp"

namespace pal::runtime {

struct Event {
  enum class Kind : std::uint8_t {
    work_done,          // subject: a processor
    message_available,  // a channel
    wait_expired,       // a thread
    request_arrives,    // a channel
    device_action       // the number of the action
  };
  Time time{};
  std::uint64_t order = 0;  // names the event; from 1 on
  Kind kind = Kind::work_done;
  std::int32_t subject = 0;
};

/// An action of a device.
struct DeviceAction {
  int device = -1;
  std::function<void()> action;
};

/// The next event is kept apart, because it is often asked for when no other is.
class EventQueue {
 public:
  explicit EventQueue(std::size_t capacity);

  bool empty() const { return !held_ && heap_.empty(); }
  /// Contract: not empty.
  const Event& next() const { return held_ ? next_ : heap_.front(); }
  Event pop();
  /// The same without the event.
  void drop_next() {
    if (held_) {
      held_ = false;
    } else {
      pop();
    }
  }

  /// The number that names the event.
  std::uint64_t push(Time time, Event::Kind kind, std::int32_t subject) {
    const std::uint64_t order = ++order_;
    if (empty() || time < next().time) {  // of one instant it would be the last
      if (held_) push_heap(next_);
      // One by one: copying an event that was just made waits for its parts.
      next_.time = time;
      next_.order = order;
      next_.kind = kind;
      next_.subject = subject;
      held_ = true;
    } else {
      push_heap({time, order, kind, subject});
    }
    return order;
  }
  std::uint64_t push_action(Time time, int device, std::function<void()> action);

  /// Removes the event. If it has happened, nothing changes.
  void cancel(std::uint64_t order);

  /// The action of an event that was popped; forgotten by the queue.
  DeviceAction take_action(const Event& event);

 private:
  static bool before(const Event& a, const Event& b) {
    return a.time != b.time ? a.time < b.time : a.order < b.order;
  }
  static bool later(const Event& a, const Event& b) { return before(b, a); }
  void push_heap(const Event& event);
  void forget(const Event& event);

  Event next_;
  bool held_ = false;  // next_ is the next event; otherwise it is the heap's
  std::vector<Event> heap_;
  std::vector<DeviceAction> actions_;
  std::vector<std::int32_t> free_actions_;
  std::uint64_t order_ = 0;
};

}  // namespace pal::runtime
