#include "runtime/kernel/mail.hpp"

#include <algorithm>
#include <utility>

#include "runtime/kernel/devices.hpp"
#include "runtime/kernel/ports.hpp"
#include "runtime/kernel/promises.hpp"

namespace pal::runtime {

using trace::Kind;

namespace {
// So that nothing is allocated while the skill runs: at one slot more threads hardly ever wait.
constexpr std::size_t usual_asked = 16, usual_waiting = 16;

/// A trace has 31 bits for a serial number: those on their way at one time are told apart all the same.
std::int32_t in_trace(std::int64_t serial) {
  return static_cast<std::int32_t>(serial & 0x7fffffff);
}
}  // namespace

Mail::Mail(Executive& executive, Journal& journal, Flow& flow, Devices& devices, Promises& promises,
           const Wiring& wiring)
    : executive_(executive),
      journal_(journal),
      flow_(flow),
      devices_(devices),
      promises_(promises),
      wiring_(wiring) {
  for (const ChannelSpec& spec : wiring.channels) {
    slots_.emplace_back();
    Slot& slot = slots_.back();
    slot.spec = &spec;
    slot.fields.resize(payload_size(spec.fields));
    slot.asked.reserve(usual_asked);
    slot.waiting.reserve(std::min(wiring.threads.size(), usual_waiting));
    slot.sending.reserve(std::min(wiring.threads.size(), usual_waiting));
  }
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const int answer = wiring.channels[i].answer;
    if (answer < 0) continue;
    at(answer).request_of = static_cast<int>(i);
    requests_.push_back(static_cast<int>(i));
  }
  parties_.resize(wiring.devices.size());
  const auto none = [](const Interval& time) { return time.best == Time() && time.worst == Time(); };
  at_once_ = none(wiring.latency.within_processor) && none(wiring.latency.between_processors);
}

void Mail::connect(int channel, int device, std::size_t port) {
  Slot& slot = at(channel);
  slot.device = device;
  slot.port = port;
  Party& party = parties_[static_cast<std::size_t>(device)];
  party.sends_events = party.sends_events || (slot.spec->from_device && slot.request_of < 0);
  if (slot.spec->to_device) party.inbox.push_back(channel);
}

bool Mail::available(const Slot& slot, const Thread& thread) const {
  if (!slot.full || slot.claimed != nullptr) return false;
  const bool near = slot.sender_processor == thread.control.spec->processor;
  return (near ? slot.available_within : slot.available_between) <= executive_.now();
}

// Waiting and taking.

void Mail::reach(WaitOperation& wait) {
  if (wait.within()) wait.deadline = executive_.now() + *wait.within();
  for (const Target& target : wait.targets()) {
    const Slot& slot = at(target.channel);
    if (slot.spec->from_device) devices_.open(slot.device);
  }
  look(wait);
}

void Mail::look(WaitOperation& wait) {
  Thread& thread = wait.thread();
  const auto targets = wait.targets();
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (available(at(targets[i].channel), thread)) {
      claim(wait, static_cast<int>(i));
      return;
    }
  }
  if (wait.within() && wait.deadline <= executive_.now()) {
    give_up(wait);
    return;
  }
  thread.control.waiting = &wait;
  for (const Target& target : targets) {
    std::vector<Thread*>& queue = at(target.channel).waiting;
    if (targets.size() == 1 || queue.empty() || queue.back() != &thread) queue.push_back(&thread);
  }
  flow_.block(thread, targets.front().channel);
  if (wait.within())
    thread.control.expiry = executive_.at(wait.deadline, {Due::Kind::wait_expired, thread.control.index});
}

/// The thread waits for nothing any more.
void Mail::stop_waiting(Thread& thread) {
  ThreadControl& control = thread.control;
  if (control.waiting == nullptr) return;
  for (const Target& target : control.waiting->targets()) {
    std::vector<Thread*>& waiting = at(target.channel).waiting;
    if (waiting.size() == 1 && waiting.front() == &thread) {
      waiting.pop_back();
    } else {
      std::erase(waiting, &thread);
    }
  }
  control.waiting = nullptr;
  if (control.expiry.number != 0) executive_.cancel(std::exchange(control.expiry, {}));
}

void Mail::claim(WaitOperation& wait, int target) {
  Thread& thread = wait.thread();
  wait.chosen = target;
  const int channel = wait.targets()[static_cast<std::size_t>(target)].channel;
  at(channel).claimed = &thread;
  thread.control.claimed = channel;
  stop_waiting(thread);
  executive_.need_processor(thread, wiring_.statements[static_cast<std::size_t>(wait.statement())].cost);
}

void Mail::give_up(WaitOperation& wait) {
  journal_.record(Kind::give_up, wait.thread(), wait.targets().front().channel);
  wait.chosen = -1;
  stop_waiting(wait.thread());
  executive_.need_processor(wait.thread(), wiring_.test);
}

void Mail::wait_expired(Thread& thread) {
  thread.control.expiry = {};
  give_up(*thread.control.waiting);
}

bool Mail::finish(WaitOperation& wait) {
  Thread& thread = wait.thread();
  const auto targets = wait.targets();
  if (wait.chosen < 0) {
    for (const Target& target : targets) {
      const int request = at(target.channel).request_of;
      if (request >= 0) withdraw(at(request), nullptr);
    }
    journal_.record(Kind::done, thread);
    flow_.proceed(thread);
    return true;
  }
  const Target& target = targets[static_cast<std::size_t>(wait.chosen)];
  Slot& slot = at(target.channel);
  thread.control.claimed = -1;
  if (slot.claimed != &thread) {  // withdrawn while it was being received: there was nothing
    if (thread.control.cancelled) return false;
    reach(wait);
    return true;
  }
  if (target.store != nullptr) target.store(target.message, slot.fields);
  journal_.record(Kind::take, thread, target.channel, in_trace(slot.serial));
  empty(slot);
  journal_.record(Kind::done, thread);
  flow_.proceed(thread);
  return true;
}

void Mail::message_available(int channel) {
  const Slot& slot = at(channel);
  for (Thread* thread : slot.waiting) {
    if (!available(slot, *thread)) continue;
    const auto targets = thread->control.waiting->targets();
    int target = 0;
    while (targets[static_cast<std::size_t>(target)].channel != channel) ++target;
    claim(*thread->control.waiting, target);
    return;
  }
}

// Putting.

bool Mail::send(SendOperation& send) {
  Thread& thread = send.thread();
  Slot& slot = at(send.channel());
  if (slot.request_of >= 0 && discards(slot)) {
    discard(send);
    return true;
  }
  if (slot.full) {
    if (thread.control.cancelled) return false;
    thread.control.sending = &send;
    slot.sending.push_back(&thread);
    flow_.block(thread, send.channel());
    return true;
  }
  put_done(send);
  return true;
}

void Mail::stop_sending(Slot& slot, Thread& thread) {
  if (thread.control.sending == nullptr) return;
  thread.control.sending = nullptr;
  std::erase(slot.sending, &thread);
}

/// The message is not wanted any more.
void Mail::discard(SendOperation& send) {
  Thread& thread = send.thread();
  Slot& slot = at(send.channel());
  stop_sending(slot, thread);
  answered_in_vain(slot);
  journal_.record(Kind::drop, thread, send.channel(), in_trace(++serials_));
  journal_.record(Kind::done, thread);
  flow_.proceed(thread);
}

void Mail::put_done(SendOperation& send) {
  Thread& thread = send.thread();
  Slot& slot = at(send.channel());
  stop_sending(slot, thread);
  fill(slot, send.payload());
  journal_.record(Kind::put, thread, send.channel(), in_trace(slot.serial));
  journal_.record(Kind::done, thread);
  flow_.proceed(thread);
  set_out(slot, send.channel(), thread);
}

void Mail::fill(Slot& slot, std::span<const double> fields) {
  slot.answers = answered_next(slot) != nullptr;
  slot.full = true;
  slot.handed = false;
  slot.claimed = nullptr;
  slot.serial = ++serials_;
  std::copy(fields.begin(), fields.end(), slot.fields.begin());
}

/// What was put goes on its way.
void Mail::set_out(Slot& slot, int channel, const Thread& sender) {
  if (slot.spec->request) ask(slot, &sender);
  if (slot.spec->to_device) {
    if (!parties_[static_cast<std::size_t>(slot.device)].sends_events) devices_.open(slot.device);
    if (slot.spec->request) {
      // As an event of its own: the device may be in the middle of taking the request before this one.
      slot.arrivals[0] = executive_.at(executive_.now(), {Due::Kind::request_arrives, channel});
    } else {
      taken_by_device(slot);
      devices_.hand_to(slot.device, slot.port, slot.fields);
    }
    return;
  }
  slot.sender_processor = sender.control.spec->processor;
  if (at_once_) {
    slot.available_within = slot.available_between = executive_.now();
    message_available(channel);
    return;
  }
  const Latency& latency = wiring_.latency;
  slot.available_within = executive_.now() + executive_.latency(latency.within_processor);
  slot.available_between = executive_.now() + executive_.latency(latency.between_processors);
  const std::array<Time, 2> times{slot.available_within, slot.available_between};
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] > executive_.now())
      slot.arrivals[i] = executive_.at(times[i], {Due::Kind::message_available, channel});
  }
  message_available(channel);
}

/// The message is taken, or withdrawn.
void Mail::empty(Slot& slot) {
  if (slot.answers) {
    std::vector<Asked>& asked = at(slot.request_of).asked;
    if (asked.size() == 1) {
      asked.pop_back();
    } else {
      asked.erase(asked.begin());
    }
  }
  slot.full = slot.answers = false;
  slot.claimed = nullptr;
  if (!at_once_ || slot.spec->to_device) {
    for (Ticket& arrival : slot.arrivals)
      if (arrival.number != 0) executive_.cancel(std::exchange(arrival, {}));
  }
  if (slot.sending.empty()) return;
  SendOperation& longest = *slot.sending.front()->control.sending;
  if (discards(slot)) {
    discard(longest);
    empty(slot);
  } else {
    put_done(longest);
  }
}

// Withdrawing.

void Mail::drop(Slot& slot) {
  journal_.record_drop(index(slot), in_trace(slot.serial));
  empty(slot);
}

/// What the thread has begun to receive is free again.
void Mail::release(Slot& slot, const Thread& thread) {
  if (slot.claimed != &thread) return;
  slot.claimed = nullptr;
  message_available(index(slot));
}

void Mail::abandon(Thread& thread) {
  ThreadControl& control = thread.control;
  stop_waiting(thread);
  if (control.sending != nullptr) stop_sending(at(control.sending->channel()), thread);
  // In the order of the channels.
  int claimed = std::exchange(control.claimed, -1);
  for (const int request : requests_) {
    if (claimed >= 0 && claimed <= request) release(at(std::exchange(claimed, -1)), thread);
    withdraw(at(request), &thread);
  }
  if (claimed >= 0) release(at(claimed), thread);
}

// Devices.

void Mail::taken_by_device(Slot& slot) {
  journal_.record_device(Kind::take, slot.device, index(slot), in_trace(slot.serial));
  empty(slot);
}

void Mail::request_arrives(int channel) {
  Slot& slot = at(channel);
  slot.arrivals[0] = {};
  slot.handed = true;
  promises_.asked(slot.device);
  devices_.hand_to(slot.device, slot.port, slot.fields, static_cast<std::uint64_t>(slot.serial));
}

void Mail::device_takes_request(int device) {
  Slot* oldest = nullptr;
  for (const int channel : parties_[static_cast<std::size_t>(device)].inbox) {
    Slot& slot = at(channel);
    const bool waits = slot.full && slot.handed;
    if (waits && (oldest == nullptr || slot.serial < oldest->serial)) oldest = &slot;
  }
  if (oldest != nullptr) taken_by_device(*oldest);
}

/// Before a message of a device is put, discarded or lost.
void Mail::watch_device(const Slot& slot, int channel) {
  if (slot.request_of < 0) {
    promises_.sent(slot.device, channel);
  } else if (const Asked* next = answered_next(slot)) {
    promises_.answered(slot.device, channel, next->put);
  }
}

bool Mail::deliver(int channel, std::span<const double> fields, std::uint64_t request) {
  Slot& slot = at(channel);
  if (slot.request_of >= 0 && !find_request(slot, request)) {
    promises_.unasked(slot.device, channel);
    journal_.record_device(Kind::drop, slot.device, channel, trace::unasked);
    return true;
  }
  if (discards(slot)) {
    watch_device(slot, channel);
    answered_in_vain(slot);
    journal_.record_device(Kind::drop, slot.device, channel, in_trace(++serials_));
    return true;
  }
  watch_device(slot, channel);
  if (slot.full) {
    answered_in_vain(slot);
    journal_.overrun(slot.device, channel);
    return false;
  }
  fill(slot, fields);
  if (slot.spec->request) ask(slot, nullptr);
  slot.sender_processor = -1;
  slot.available_within = slot.available_between = executive_.now();
  journal_.record_device(Kind::put, slot.device, channel, in_trace(slot.serial));
  message_available(channel);
  return true;
}

}  // namespace pal::runtime
