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

void EventQueue::push_action(Time time, std::uint64_t token, std::function<void()> action) {
  std::int32_t slot = 0;
  if (free_actions_.empty()) {
    slot = static_cast<std::int32_t>(actions_.size());
    actions_.push_back(std::move(action));
  } else {
    slot = free_actions_.back();
    free_actions_.pop_back();
    actions_[static_cast<std::size_t>(slot)] = std::move(action);
  }
  push(time, Event::Kind::device_action, slot, token);
}

std::function<void()> EventQueue::take_action(const Event& event) {
  free_actions_.push_back(event.subject);
  return std::exchange(actions_[static_cast<std::size_t>(event.subject)], nullptr);
}

}  // namespace pal::runtime
