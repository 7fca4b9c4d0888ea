#include "runtime/event_queue.hpp"

#include <algorithm>
#include <utility>

namespace pal::runtime {

namespace {

bool later(const Event& a, const Event& b) {
  return a.time != b.time ? a.time > b.time : a.order > b.order;
}

}  // namespace

EventQueue::EventQueue(std::size_t capacity) {
  heap_.reserve(capacity);
  actions_.reserve(capacity);
  free_actions_.reserve(capacity);
}

Event EventQueue::pop() {
  std::pop_heap(heap_.begin(), heap_.end(), later);
  const Event event = heap_.back();
  heap_.pop_back();
  return event;
}

void EventQueue::push(Time time, Event::Kind kind, std::int32_t subject, std::uint64_t token) {
  heap_.push_back({time, order_++, kind, subject, token});
  std::push_heap(heap_.begin(), heap_.end(), later);
}

DeviceHost::Appointment EventQueue::push_action(Time time, std::uint64_t token,
                                                std::function<void()> action) {
  if (free_actions_.empty()) {
    free_actions_.push_back(static_cast<std::int32_t>(actions_.size()));
    actions_.emplace_back();
  }
  const std::int32_t slot = free_actions_.back();
  free_actions_.pop_back();
  actions_[static_cast<std::size_t>(slot)] = {std::move(action), order_};
  const DeviceHost::Appointment appointment{static_cast<std::uint32_t>(slot), order_};
  push(time, Event::Kind::device_action, slot, token);
  return appointment;
}

void EventQueue::cancel(DeviceHost::Appointment appointment) {
  if (appointment.order != 0 && appointment.slot < actions_.size() &&
      actions_[appointment.slot].order == appointment.order)
    release(appointment.slot);
}

bool EventQueue::expects_action(const Event& event) const {
  return actions_[static_cast<std::size_t>(event.subject)].order == event.order;
}

std::function<void()> EventQueue::take_action(const Event& event) {
  return release(static_cast<std::size_t>(event.subject));
}

std::function<void()> EventQueue::release(std::size_t slot) {
  free_actions_.push_back(static_cast<std::int32_t>(slot));
  actions_[slot].order = 0;
  return std::exchange(actions_[slot].call, nullptr);
}

}  // namespace pal::runtime
