// What meters ask of the tables of a trace: which messages answer which, and which actors are devices.
#pragma once

#include <cstdint>
#include <vector>

#include "pal/trace/meter.hpp"

namespace pal::trace {

/// By channel: the channel of the requests that its messages answer, or -1.
std::vector<std::int32_t> requests_of(const Trace& tables);
/// By channel: the channel on which its messages are answered, or -1.
std::vector<std::int32_t> answers_of(const std::vector<std::int32_t>& request_of);
/// By actor.
std::vector<bool> devices_of(const Trace& tables);

/// A block begins with what its parent has.
template <class Value>
void inherit(const Event& event, std::int32_t parent, std::vector<Value>& of_actor) {
  if (parent >= 0)
    of_actor[static_cast<std::size_t>(event.actor)] = of_actor[static_cast<std::size_t>(parent)];
}

/// One list a channel; those of requests that are answered have room.
template <class Value>
std::vector<std::vector<Value>> room_for_requests(const std::vector<std::int32_t>& request_of) {
  constexpr std::size_t usual_requests = 16;  // of a channel that a device is at work on
  std::vector<std::vector<Value>> lists(request_of.size());
  for (const std::int32_t request : request_of)
    if (request >= 0) lists[static_cast<std::size_t>(request)].reserve(usual_requests);
  return lists;
}

/// The first of the list, which is removed; otherwise `none`.
template <class Value>
Value take_first(std::vector<Value>& list, Value none) {
  if (list.empty()) return none;
  const Value first = list.front();
  list.erase(list.begin());
  return first;
}

}  // namespace pal::trace
