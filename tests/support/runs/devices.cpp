// The world at the other end of messages.
#include "tests/support/runs/all_runs.hpp"

#include <algorithm>
#include <utility>

namespace pal::test {

using namespace pan;
using namespace runs;

void AllRuns::open(int process) {
  Device& device = s_.devices[ix(process)];
  const Process& of = processes_[ix(process)];
  const auto* event = of.timing == nullptr ? nullptr : std::get_if<EventDevice>(&of.timing->behaviour);
  if (event == nullptr || device.open) return;
  device.open = true;
  device.next = event->phase ? draw({*event->phase, *event->phase}) : draw({Duration(0), event->period});
}

void AllRuns::event(int process) {
  Device& device = s_.devices[ix(process)];
  const auto& event = std::get<EventDevice>(processes_[ix(process)].timing->behaviour);
  device.next =
      event.sporadic ? draw({event.period, event.period + 4 * unit_}) : draw({event.period, event.period});
  if (event.jitter.count() > 0) {
    device.late = draw({Duration(0), event.jitter});
    return;
  }
  occurs(process);
}

void AllRuns::occurs(int process) {
  const int channel = processes_[ix(process)].event;
  const bool lost = s_.slots[ix(channel)].full;
  const int carries = lost ? -1 : has_occurred(channel);
  occurrence(process, lost);
  put(channel, -1, process, carries);
  if (!lost) s_.slots[ix(channel)].later = counts(process) && in_question() ? 0 : -1;
  if (!lost) offer(channel);
}

void AllRuns::take_request(int process, int channel) {
  const Process& of = processes_[ix(process)];
  const bool serves = std::find(of.requests.begin(), of.requests.end(), channel) != of.requests.end();
  if (!serves) {
    take(channel, -1);
    clear(channel);
    return;
  }
  if (std::holds_alternative<RequestDevice>(of.timing->behaviour) && s_.devices[ix(process)].serving == 0)
    next_request(process);
}

/// An idle device that answers on request takes one of what waits.
void AllRuns::next_request(int process) {
  const Process& of = processes_[ix(process)];
  std::vector<int> waiting;
  for (std::size_t i = 0; i < of.requests.size(); ++i) {
    if (s_.slots[ix(of.requests[i])].full) waiting.push_back(static_cast<int>(i));
  }
  if (waiting.empty() || s_.devices[ix(process)].serving != 0) return;
  const int chosen =
      waiting[ix(waiting.size() == 1 ? 0 : decisions_->pick(static_cast<int>(waiting.size())))];
  const int channel = of.requests[ix(chosen)];
  new_sample_ = true;
  s_.devices[ix(process)].serving = 1U << chosen;
  s_.devices[ix(process)].service = draw(std::get<RequestDevice>(of.timing->behaviour).answer);
  s_.slots[ix(channel)].serving_carries = is_served(channel);
  clear(channel);
  say(of.name + " takes a request");
  if (somebody_sends(channel)) later([this, channel] { emptied(channel); });
}

void AllRuns::frame(int process) {
  const Process& of = processes_[ix(process)];
  const auto& frames = std::get<FrameDevice>(of.timing->behaviour);
  Device& device = s_.devices[ix(process)];
  device.next = draw({frames.period, frames.period});
  std::vector<int> waiting;
  for (std::size_t i = 0; i < of.requests.size(); ++i) {
    if (s_.slots[ix(of.requests[i])].full) waiting.push_back(static_cast<int>(i));
  }
  if (waiting.empty()) {
    if (s_.counting) occurrence(process, true);
    return;
  }
  new_sample_ = true;
  device.service = draw({frames.collecting, frames.collecting});
  for (int i : waiting) {
    const int request = of.requests[ix(i)];
    device.serving |= 1U << i;
    s_.slots[ix(request)].serving_carries = is_served(request);
    clear(request);
  }
  for (int i : waiting) {
    const int request = of.requests[ix(i)];
    if (somebody_sends(request)) later([this, request] { emptied(request); });
  }
}

void AllRuns::answer(int process) {
  const Process& of = processes_[ix(process)];
  Device& device = s_.devices[ix(process)];
  std::vector<int> served;
  for (std::size_t i = 0; i < of.requests.size(); ++i) {
    if ((device.serving >> i & 1U) != 0) served.push_back(static_cast<int>(i));
  }
  const bool arrives = std::any_of(served.begin(), served.end(), [&](int i) {
    const int channel = network_.channels[ix(of.requests[ix(i)])].answer.value;
    return !s_.slots[ix(channel)].full && !discards(channel);
  });
  const auto* request_device = std::get_if<RequestDevice>(&of.timing->behaviour);
  const bool on_request = request_device != nullptr;
  device.service = -1;
  device.serving = 0;
  if (on_request && request_device->may_fail) {
    const int request = of.requests[ix(served.front())];
    const int channel = network_.channels[ix(request)].answer.value;
    if (!discards(channel) && decisions_->pick(2) == 1) {
      s_.slots[ix(request)].serving_carries = -1;
      answered_in_vain(channel);
      later([this, process] { next_request(process); });
      return;
    }
  }
  occurrence(process, !arrives);
  for (int i : served) {
    const int request = of.requests[ix(i)];
    Slot& slot = s_.slots[ix(request)];
    slot.due_carries = std::exchange(slot.serving_carries, -1);
    later([this, process, request] { answers(process, request); });
  }
  if (on_request) later([this, process] { next_request(process); });
}

/// What a device has served is there, or lost, or not wanted any more.
void AllRuns::answers(int process, int request) {
  const int carries = std::exchange(s_.slots[ix(request)].due_carries, -1);
  const int channel = network_.channels[ix(request)].answer.value;
  if (discards(channel)) {
    answered_in_vain(channel);
    return;
  }
  const bool lost = s_.slots[ix(channel)].full;
  put(channel, -1, process, carries);
  if (lost) return;
  s_.slots[ix(channel)].later = counts(process) && in_question() ? 0 : -1;
  offer(channel);
}

/// Whether a device may wait for ever: then not all runs can be tried.
bool AllRuns::sporadic() const {
  for (const DeviceTiming& timing : environment_.devices) {
    const auto* event = std::get_if<EventDevice>(&timing.behaviour);
    if (event != nullptr && event->sporadic) return true;
  }
  return false;
}

}  // namespace pal::test
