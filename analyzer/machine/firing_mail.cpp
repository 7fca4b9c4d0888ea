// Messages and the devices at the other end of them.
#include <algorithm>
#include <utility>

#include "analyzer/machine/firing.hpp"

namespace pal::analyzer {

/// The message is in its slot; announce() is still to be called.
void Firing::place(ChannelId channel, ThreadId thread, DeviceId device, std::uint8_t carries) {
  SlotState& to = slot(channel);
  fill(channel, thread);
  to.carries = awaits_response(channel) ? new_event() : carries;
  if (device.valid()) {
    emit_device(Kind::put, device, channel);
  } else {
    emit(Kind::put, thread, channel);
  }
  to.answers = answered_next(channel) >= 0;
  ask(channel, thread);
}

void Firing::announce(ChannelId channel) {
  if (channel_of(channel).receiver_device.valid()) {
    arrives_at_device(channel);
  } else {
    const ThreadId thread = claimed_by(channel);
    if (thread.valid()) queue_later(thread);
  }
}

/// Whether what else follows from a send at this instant has to do with its thread's processor alone.
bool Firing::stays_at_home(ThreadId sender) const {
  const ThreadState& of = state_of(sender);
  const Step::Kind next = problem_.steps[step_of(sender).next.front()].kind;
  return of.status == Status::running && !of.cancelled && due_.empty() && next != Step::Kind::fork &&
         next != Step::Kind::end;
}

/// The message sets out for the processors on which a thread waits for it. `sender`: -1: a device.
void Firing::fill(ChannelId channel, ThreadId sender) {
  const ProcessorId processor = !sender.valid() ? ProcessorId{} : thread_of(sender).processor;
  SlotState& to = slot(channel);
  to.fill = SlotState::Fill::full;
  to.from = processor;
  to.near = to.far = SlotState::Way::there;
  if (!processor.valid() || channel_of(channel).receiver_device.valid()) return;
  bool near = false;
  bool far = false;
  for (ProcessorId receiver : channel_of(channel).receiver_processors)
    (receiver == processor ? near : far) = true;
  // A way of no length may be over before anything else happens, as if there were no latency. To threads on
  // other processors alone, on which nothing else happens, that is as if it were over afterwards.
  const bool alike = !near && stays_at_home(sender);
  const auto fly = [this, alike](SlotState::Way& way, int timer, Range latency) {
    if (latency.worst == 0) return;
    if (latency.best == 0 && !alike && choices_.pick(2) == 1) {
      outcome_.hurried = true;
      return;
    }
    way = SlotState::Way::flying;
    start_timer(timer, latency);
  };
  if (near) fly(to.near, machine_.flight_timer(channel), problem_.within_processor);
  if (far) fly(to.far, machine_.flight_timer(channel) + 1, problem_.between_processors);
}

bool Firing::available(ChannelId channel, ThreadId thread) const {
  const SlotState& of = state_.slots[channel];
  if (of.fill != SlotState::Fill::full) return false;
  return (of.from == thread_of(thread).processor ? of.near : of.far) == SlotState::Way::there;
}

/// Gives the message to one of the threads that wait for it, if any, which has to come to its queue yet.
ThreadId Firing::claimed_by(ChannelId channel) {
  std::vector<std::pair<ThreadId, int>> waiting;
  for (const ThreadId t : problem_.threads.ids()) {
    if (state_.threads[t].status != Status::waiting || !available(channel, t)) continue;
    const Step& step = step_of(t);
    for (std::size_t i = 0; i < step.channels.size(); ++i) {
      if (step.channels[i] == channel) waiting.emplace_back(t, static_cast<int>(i));
    }
  }
  if (waiting.empty()) return {};
  const std::size_t chosen =
      waiting.size() == 1 ? 0 : static_cast<std::size_t>(choices_.pick(static_cast<int>(waiting.size())));
  const auto [thread, branch] = waiting[chosen];
  stop_waiting(thread);
  slot(channel).fill = SlotState::Fill::claimed;
  state_of(thread).choice = static_cast<std::int8_t>(branch);
  state_of(thread).status = Status::ready;
  state_of(thread).begun = false;
  return thread;
}

/// Gives the message to one of the threads that wait for it, if any.
void Firing::message_available(ChannelId channel) {
  const ThreadId thread = claimed_by(channel);
  if (!thread.valid()) return;
  enqueue(thread, false);
  queued_.push_back(thread);
}

/// The message leaves its slot; empty() is still to be called.
void Firing::take(ChannelId channel, ThreadId thread, DeviceId device) {
  SlotState& from = slot(channel);
  if (device.valid()) {
    emit_device(Kind::take, device, channel);
  } else {
    emit(Kind::take, thread, channel);
    has_taken(thread, channel, from.carries);
  }
  if (from.answers) slot(channel_of(channel).answers).asked.erase(0);
}

/// Frees the slot, for a sender that is blocked perhaps.
void Firing::empty(ChannelId channel) {
  clear(channel);
  admit_later(channel);
}

/// The slot is free; admit() is still to be called.
void Firing::clear(ChannelId channel) {
  SlotState& of = slot(channel);
  if (of.near == SlotState::Way::flying) stop_timer(machine_.flight_timer(channel));
  if (of.far == SlotState::Way::flying) stop_timer(machine_.flight_timer(channel) + 1);
  of.fill = SlotState::Fill::empty;
  of.near = of.far = SlotState::Way::none;
  of.from = ProcessorId{};
  of.carries = tag::none;
  of.answers = false;
}

bool Firing::somebody_sends(ChannelId channel) const {
  for (const ThreadId t : problem_.threads.ids()) {
    if (state_.threads[t].status == Status::sending && step_of(t).channels.front() == channel) return true;
  }
  return false;
}

/// The threads that wait for a message of the channel.
std::vector<ThreadId> Firing::waiting_for(ChannelId channel) const {
  std::vector<ThreadId> waiting;
  for (const ThreadId t : problem_.threads.ids()) {
    if (state_.threads[t].status != Status::waiting) continue;
    const std::vector<ChannelId>& channels = step_of(t).channels;
    if (std::find(channels.begin(), channels.end(), channel) != channels.end()) waiting.push_back(t);
  }
  return waiting;
}

/// The slot is there for a sender that is blocked, unless another party has filled it.
void Firing::admit(ChannelId channel) {
  SlotState& of = slot(channel);
  if (of.fill != SlotState::Fill::empty) return;
  std::vector<ThreadId> senders;
  for (const ThreadId t : problem_.threads.ids()) {
    if (state_.threads[t].status == Status::sending && step_of(t).channels.front() == channel) {
      senders.push_back(t);
    }
  }
  if (senders.empty()) return;
  const ThreadId sender = senders[static_cast<std::size_t>(
      senders.size() == 1 ? 0 : choices_.pick(static_cast<int>(senders.size())))];
  state_of(sender).status = Status::ready;
  if (discards(channel)) {
    discard(channel);
    emit(Kind::drop, sender, channel);
    sent(sender, false);
    admit_later(channel);
    return;
  }
  sent(sender, true);
}

/// A thread withdrew the message that is in the slot, or on its way to it.
void Firing::drop(ChannelId channel) {
  SlotState& of = slot(channel);
  if (of.fill == SlotState::Fill::claimed) {
    for (const ThreadId t : problem_.threads.ids()) {
      ThreadState& thread = state_.threads[t];
      if (thread.status != Status::ready && thread.status != Status::running) continue;
      const Step& step = step_of(t);
      if (step.kind != Step::Kind::wait || thread.choice < 0 || step.channels.empty()) continue;
      if (step.channels[static_cast<std::size_t>(thread.choice)] == channel)
        thread.choice = ThreadState::withdrawn;
    }
  }
  if (record_) outcome_.events.push_back({0, Kind::drop, -1, -1, channel.value, 0});
  lost_after_all(channel);
  if (awaits_response(channel) && of.carries != tag::none) forget_event(of.carries);
  clear(channel);
}

void Firing::open_device(DeviceId device) {
  DeviceState& state = state_.devices[device];
  const auto* event = std::get_if<pan::EventDevice>(&problem_.devices[device].behaviour);
  if (event == nullptr || state.open) return;
  state.open = true;
  Range first{0, event->sporadic ? Range::unbounded : event->period.count()};
  if (event->phase) first = {event->phase->count(), event->phase->count()};
  start_timer(machine_.next_timer(device), first);
}

void Firing::arrives_at_device(ChannelId channel) {
  const Channel& of = channel_of(channel);
  const DeviceId device = of.receiver_device;
  if (!of.served) {
    take(channel, ThreadId{}, device);
    empty(channel);
    return;
  }
  const bool idle = state_.devices[device].serving.none();
  if (idle && std::holds_alternative<pan::RequestDevice>(problem_.devices[device].behaviour)) {
    take_pending(device);
  }
}

/// The device takes what is pending: one request if it answers on request, all of them for a frame.
void Firing::take_pending(DeviceId device) {
  const Device& of = problem_.devices[device];
  std::vector<std::size_t> pending;
  for (std::size_t i = 0; i < of.requests.size(); ++i) {
    if (slot(of.requests[i]).fill == SlotState::Fill::full) pending.push_back(i);
  }
  const auto* request = std::get_if<pan::RequestDevice>(&of.behaviour);
  if (request != nullptr && pending.size() > 1) {
    pending = {pending[static_cast<std::size_t>(choices_.pick(static_cast<int>(pending.size())))]};
  }
  if (request == nullptr) emit_device(Kind::busy, device);
  if (pending.empty()) {
    if (request == nullptr && state_.counting) occurrence(device, true);
    return;
  }
  if (request != nullptr) emit_device(Kind::busy, device);
  for (std::size_t i : pending) {
    state_.devices[device].serving.set(i);
    slot(of.requests[i]).serving_carries = sampled(of.requests[i]);
    take(of.requests[i], ThreadId{}, device);
  }
  if (request != nullptr) {
    start_timer(machine_.service_timer(device),
                {request->answer.best.count(), request->answer.worst.count()});
  } else {
    const Nanoseconds collecting = std::get<pan::FrameDevice>(of.behaviour).collecting.count();
    start_timer(machine_.service_timer(device), {collecting, collecting});
  }
  for (std::size_t i : pending) empty(of.requests[i]);
}

void Firing::device_next(DeviceId device) {
  const auto& behaviour = problem_.devices[device].behaviour;
  if (const auto* event = std::get_if<pan::EventDevice>(&behaviour)) {
    const Nanoseconds period = event->period.count();
    start_timer(machine_.next_timer(device), {period, event->sporadic ? Range::unbounded : period});
    if (event->jitter.count() > 0) {
      state_.devices[device].late = true;
      start_timer(machine_.service_timer(device), {0, event->jitter.count()});
    } else {
      event_occurs(device);
    }
    return;
  }
  const Nanoseconds period = std::get<pan::FrameDevice>(behaviour).period.count();
  const bool seldom = problem_.devices[device].seldom;
  start_timer(machine_.next_timer(device), {period, seldom ? Range::unbounded : period});
  take_pending(device);
}

void Firing::device_service(DeviceId device) {
  const Device& of = problem_.devices[device];
  DeviceState& state = state_.devices[device];
  if (std::holds_alternative<pan::EventDevice>(of.behaviour)) {
    state.late = false;
    event_occurs(device);
    return;
  }
  const DeviceState::Served served = state.serving;
  state.serving.reset();
  emit_device(Kind::idle, device);
  if (never_answers(of, served)) {
    due_.push_back({Due::What::serve, device.value});
    return;
  }
  if (counts_losses(device)) occurrence(device, !arrives(device, served));
  for (std::size_t i = 0; i < of.requests.size(); ++i) {
    if (!served[i]) continue;
    const ChannelId request = of.requests[i];
    const std::uint8_t carries = !counts_losses(device)
                                     ? std::exchange(slot(request).serving_carries, tag::none)
                                 : counts() ? std::uint8_t{0}
                                            : tag::none;
    due_.push_back({Due::What::answer, request.value, {}, carries});
  }
  if (std::holds_alternative<pan::RequestDevice>(of.behaviour))
    due_.push_back({Due::What::serve, device.value});
}

/// Whether the device, which serves one request, has no answer to it though a thread waits for one: then
/// the request is open no more.
bool Firing::never_answers(const Device& of, const DeviceState::Served& served) {
  const auto* request = std::get_if<pan::RequestDevice>(&of.behaviour);
  if (request == nullptr || !request->may_fail) return false;
  for (std::size_t i = 0; i < of.requests.size(); ++i) {
    const ChannelId channel = channel_of(of.requests[i]).answer;
    if (!served[i] || discards(channel) || choices_.pick(2) == 0) continue;
    slot(of.requests[i]).serving_carries = tag::none;
    discard(channel);
    emit_device(Kind::drop, channel_of(of.requests[i]).receiver_device, channel);
    return true;
  }
  return false;
}

/// The answer to a request is there, or lost, or not wanted any more.
void Firing::answer(ChannelId request, std::uint8_t carries) {
  const ChannelId channel = channel_of(request).answer;
  const DeviceId device = channel_of(request).receiver_device;
  if (discards(channel)) {
    discard(channel);
    emit_device(Kind::drop, device, channel);
  } else if (slot(channel).fill != SlotState::Fill::empty) {
    discard(channel);
    emit_device(Kind::overrun, device, channel);
    if (awaits_response(channel) && counts()) state_.failed = true;
  } else {
    place(channel, ThreadId{}, device, carries);
    message_available(channel);
  }
}

void Firing::event_occurs(DeviceId device) {
  const ChannelId channel = problem_.devices[device].event;
  if (!channel.valid()) return;
  if (slot(channel).fill != SlotState::Fill::empty) {
    emit_device(Kind::overrun, device, channel);
    occurrence(device, true);
    if (awaits_response(channel) && counts()) state_.failed = true;
    return;
  }
  occurrence(device, false);
  place(channel, ThreadId{}, device, occurred(channel));
  message_available(channel);
}

}  // namespace pal::analyzer
