// What is going to happen, in order of time; things of one instant in the order in which they were asked for.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "runtime/device.hpp"

namespace pal::runtime {

struct Event {
  enum class Kind : std::uint8_t {
    work_done,
    message_available,
    wait_expired,
    request_arrives,
    device_action
  };
  Time time{};
  std::uint64_t order = 0;
  Kind kind = Kind::work_done;
  std::int32_t subject = 0;  // processor, channel, thread, channel, or number of the action
  std::uint64_t token = 0;   // the event is stale when its subject has moved on to another token
};

class EventQueue {
 public:
  explicit EventQueue(std::size_t capacity);

  bool empty() const { return heap_.empty(); }
  const Event& next() const { return heap_.front(); }
  Event pop();

  void push(Time time, Event::Kind kind, std::int32_t subject, std::uint64_t token);
  /// `token` names the device.
  DeviceHost::Appointment push_action(Time time, std::uint64_t token, std::function<void()> action);
  /// Forgets the action, if it is still to come.
  void cancel(DeviceHost::Appointment appointment);
  /// Whether the action of this event is still to come; false: it was cancelled.
  bool expects_action(const Event& event) const;

  /// The action of an event that was popped; forgotten by the queue.
  std::function<void()> take_action(const Event& event);

 private:
  struct Action {
    std::function<void()> call;
    std::uint64_t order = 0;  // of its event; 0: the slot is free
  };
  std::function<void()> release(std::size_t slot);

  std::vector<Event> heap_;
  std::vector<Action> actions_;
  std::vector<std::int32_t> free_actions_;
  std::uint64_t order_ = 1;  // of the next event
};

}  // namespace pal::runtime
