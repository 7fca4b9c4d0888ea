#include "runtime/drivers/timeline.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace pal::runtime::drivers {

bool Timeline::later(const Entry& a, const Entry& b) {
  return a.time != b.time ? a.time > b.time : a.order > b.order;
}

bool Timeline::cancelled(const Entry& entry) const {
  return slots_[entry.token.slot].generation != entry.token.generation;
}

void Timeline::pop() {
  std::pop_heap(heap_.begin(), heap_.end(), later);
  heap_.pop_back();
}

std::function<void()> Timeline::release(Token token) {
  Slot& slot = slots_[token.slot];
  ++slot.generation;
  free_.push_back(token.slot);
  return std::exchange(slot.action, nullptr);
}

Timeline::Token Timeline::at(Time when, std::function<void()> action) {
  if (when < now_) {
    throw std::logic_error("asks to be called at " + std::to_string(when.count()) + " ns, which is over");
  }
  if (free_.empty()) {
    free_.push_back(static_cast<std::uint32_t>(slots_.size()));
    slots_.emplace_back();
  }
  const std::uint32_t slot = free_.back();
  free_.pop_back();
  slots_[slot].action = std::move(action);
  const Token token{slot, slots_[slot].generation};
  heap_.push_back({when, order_++, token});
  std::push_heap(heap_.begin(), heap_.end(), later);
  return token;
}

void Timeline::cancel(Token token) {
  if (token.slot < slots_.size() && slots_[token.slot].generation == token.generation) release(token);
}

Time Timeline::next() {
  while (!heap_.empty() && cancelled(heap_.front())) pop();
  return heap_.empty() ? never : heap_.front().time;
}

void Timeline::advance_to(Time when) {
  while (next() <= when) {
    const Entry entry = heap_.front();
    pop();
    now_ = entry.time;
    release(entry.token)();
  }
  now_ = std::max(now_, when);
}

}  // namespace pal::runtime::drivers
