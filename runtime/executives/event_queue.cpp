#include "runtime/executives/event_queue.hpp"

#include <algorithm>
#include <utility>

namespace pal::runtime {

EventQueue::EventQueue(std::size_t capacity) {
  heap_.reserve(capacity);
  actions_.reserve(capacity);
  free_actions_.reserve(capacity);
}

void EventQueue::push_heap(const Event& event) {
  heap_.push_back(event);
  std::push_heap(heap_.begin(), heap_.end(), later);
}

Event EventQueue::pop() {
  if (held_) {
    held_ = false;
    return next_;
  }
  std::pop_heap(heap_.begin(), heap_.end(), later);
  const Event event = heap_.back();
  heap_.pop_back();
  return event;
}

void EventQueue::forget(const Event& event) {
  if (event.kind == Event::Kind::device_action) take_action(event);
}

void EventQueue::cancel(std::uint64_t order) {
  if (held_ && next_.order == order) {
    held_ = false;
    forget(next_);
    return;
  }
  const auto found =
      std::find_if(heap_.begin(), heap_.end(), [order](const Event& event) { return event.order == order; });
  if (found == heap_.end()) return;
  forget(*found);
  *found = heap_.back();
  heap_.pop_back();
  std::make_heap(heap_.begin(), heap_.end(), later);
}

std::uint64_t EventQueue::push_action(Time time, int device, std::function<void()> action) {
  std::int32_t slot = 0;
  if (free_actions_.empty()) {
    slot = static_cast<std::int32_t>(actions_.size());
    actions_.push_back({device, std::move(action)});
  } else {
    slot = free_actions_.back();
    free_actions_.pop_back();
    actions_[static_cast<std::size_t>(slot)] = {device, std::move(action)};
  }
  return push(time, Event::Kind::device_action, slot);
}

DeviceAction EventQueue::take_action(const Event& event) {
  free_actions_.push_back(event.subject);
  return std::exchange(actions_[static_cast<std::size_t>(event.subject)], {});
}

}  // namespace pal::runtime
