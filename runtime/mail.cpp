#include "runtime/mail.hpp"

#include <algorithm>

#include "runtime/ports.hpp"
#include "runtime/run.hpp"

namespace pal::runtime {

using trace::Kind;

namespace {
constexpr std::size_t usual_asked = 16;  // so that nothing is allocated while the skill runs

/// A trace has 31 bits for a serial number: those on their way at one time are told apart all the same.
std::int32_t in_trace(std::int64_t serial) {
  return static_cast<std::int32_t>(serial & 0x7fffffff);
}
}

Mail::Mail(Run& run, const Wiring& wiring) : run_(run) {
  for (const ChannelSpec& spec : wiring.channels) {
    slots_.emplace_back();
    slots_.back().spec = &spec;
    slots_.back().fields.resize(payload_size(spec.fields));
    slots_.back().asked.reserve(usual_asked);
  }
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const int answer = wiring.channels[i].answer;
    if (answer >= 0) at(answer).request_of = static_cast<int>(i);
  }
}

void Mail::connect(int channel, int device, std::size_t port) {
  at(channel).device = device;
  at(channel).port = port;
}

bool Mail::available(const Slot& slot, const Thread& thread) const {
  if (!slot.full || slot.claimed != nullptr) return false;
  const bool near = slot.sender_processor == thread.control.spec->processor;
  return (near ? slot.available_within : slot.available_between) <= run_.now();
}

// Waiting and taking.

void Mail::reach(WaitOperation& wait) {
  if (wait.within()) wait.deadline = run_.now() + *wait.within();
  for (const Target& target : wait.targets()) {
    const Slot& slot = at(target.channel);
    if (slot.spec->from_device) run_.open_device(slot.device);
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
  if (wait.within() && wait.deadline <= run_.now()) {
    give_up(wait);
    return;
  }
  thread.control.waiting = &wait;
  run_.block(thread, targets.front().channel);
  ++thread.control.wait_token;
  if (wait.within()) {
    run_.queue().push(wait.deadline, Event::Kind::wait_expired, thread.control.index,
                      thread.control.wait_token);
  }
}

void Mail::claim(WaitOperation& wait, int target) {
  Thread& thread = wait.thread();
  wait.chosen = target;
  at(wait.targets()[static_cast<std::size_t>(target)].channel).claimed = &thread;
  thread.control.waiting = nullptr;
  ++thread.control.wait_token;
  run_.scheduler().need_processor(thread, run_.cost_of(wait.statement()));
}

void Mail::give_up(WaitOperation& wait) {
  run_.record(Kind::give_up, wait.thread(), wait.targets().front().channel);
  wait.chosen = -1;
  wait.thread().control.waiting = nullptr;
  ++wait.thread().control.wait_token;
  run_.scheduler().need_processor(wait.thread(), run_.draw(run_.wiring().test));
}

void Mail::wait_expired(Thread& thread) {
  give_up(*thread.control.waiting);
}

void Mail::finish(WaitOperation& wait) {
  Thread& thread = wait.thread();
  const auto targets = wait.targets();
  if (wait.chosen < 0) {
    for (const Target& target : targets) {
      const int request = at(target.channel).request_of;
      if (request >= 0) withdraw(at(request), nullptr);
    }
    run_.record(Kind::done, thread);
    run_.proceed(thread);
    return;
  }
  const Target& target = targets[static_cast<std::size_t>(wait.chosen)];
  Slot& slot = at(target.channel);
  if (slot.claimed != &thread) {  // withdrawn while it was being received: there was nothing
    if (thread.control.cancelled) {
      run_.blocks().stop(thread);
    } else {
      reach(wait);
    }
    return;
  }
  if (target.store != nullptr) target.store(target.message, slot.fields);
  run_.record(Kind::take, thread, target.channel, in_trace(slot.serial));
  empty(slot);
  run_.record(Kind::done, thread);
  run_.proceed(thread);
}

void Mail::message_available(int channel) {
  Thread* longest = nullptr;
  int target = -1;
  for (Thread& thread : run_.threads()) {
    const ThreadControl& control = thread.control;
    if (control.waiting == nullptr) continue;
    if (longest != nullptr && longest->control.blocked_order < control.blocked_order) continue;
    if (!available(at(channel), thread)) continue;
    const auto targets = control.waiting->targets();
    const auto found = std::find_if(targets.begin(), targets.end(),
                                    [&](const Target& candidate) { return candidate.channel == channel; });
    if (found == targets.end()) continue;
    longest = &thread;
    target = static_cast<int>(found - targets.begin());
  }
  if (longest != nullptr) claim(*longest->control.waiting, target);
}

bool Mail::expects_message(int channel, std::uint64_t serial) const {
  const Slot& slot = slots_[static_cast<std::size_t>(channel)];
  return slot.full && static_cast<std::uint64_t>(slot.serial) == serial;
}

// Putting.

void Mail::send(SendOperation& send) {
  Thread& thread = send.thread();
  Slot& slot = at(send.channel());
  if (discards(slot)) {
    discard(send);
    return;
  }
  if (slot.full) {
    if (thread.control.cancelled) {
      run_.blocks().stop(thread);
      return;
    }
    thread.control.sending = &send;
    run_.block(thread, send.channel());
    return;
  }
  put_done(send);
}

/// Nobody wants the message any more.
void Mail::discard(SendOperation& send) {
  Thread& thread = send.thread();
  thread.control.sending = nullptr;
  answered_in_vain(at(send.channel()));
  run_.record(Kind::drop, thread, send.channel(), in_trace(++serials_));
  run_.record(Kind::done, thread);
  run_.proceed(thread);
}

void Mail::put_done(SendOperation& send) {
  Thread& thread = send.thread();
  Slot& slot = at(send.channel());
  thread.control.sending = nullptr;
  fill(slot, send.payload());
  run_.record(Kind::put, thread, send.channel(), in_trace(slot.serial));
  run_.record(Kind::done, thread);
  run_.proceed(thread);
  set_out(slot, thread);
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
void Mail::set_out(Slot& slot, const Thread& sender) {
  const int channel = index(slot);
  if (slot.spec->request) ask(slot, &sender);
  if (slot.spec->to_device) {
    if (!sends_events(slot.device)) run_.open_device(slot.device);
    if (slot.spec->request) {
      // As an event of its own: the device may be in the middle of taking the request before this one.
      run_.queue().push(run_.now(), Event::Kind::request_arrives, channel,
                        static_cast<std::uint64_t>(slot.serial));
    } else {
      taken_by_device(slot);
      run_.hand_to_device(slot.device, slot.port, slot.fields);
    }
    return;
  }
  const Latency& latency = run_.wiring().latency;
  slot.sender_processor = sender.control.spec->processor;
  slot.available_within = run_.now() + run_.draw(latency.within_processor);
  slot.available_between = run_.now() + run_.draw(latency.between_processors);
  const auto token = static_cast<std::uint64_t>(slot.serial);
  for (const Time time : {slot.available_within, slot.available_between}) {
    if (time > run_.now()) run_.queue().push(time, Event::Kind::message_available, channel, token);
  }
  message_available(channel);
}

/// Whether the device sends what it was not asked for: that it does from when somebody first waits for it.
bool Mail::sends_events(int device) const {
  return std::any_of(slots_.begin(), slots_.end(), [device](const Slot& slot) {
    return slot.device == device && slot.spec->from_device && slot.request_of < 0;
  });
}

/// The message is taken, or withdrawn.
void Mail::empty(Slot& slot) {
  if (slot.answers) {
    std::vector<Asked>& asked = at(slot.request_of).asked;
    asked.erase(asked.begin());
  }
  slot.full = slot.answers = false;
  slot.claimed = nullptr;
  Thread* longest = nullptr;
  for (Thread& thread : run_.threads()) {
    const ThreadControl& control = thread.control;
    if (control.sending == nullptr || control.sending->channel() != index(slot)) continue;
    if (longest == nullptr || control.blocked_order < longest->control.blocked_order) longest = &thread;
  }
  if (longest == nullptr) return;
  if (discards(slot)) {
    discard(*longest->control.sending);
    empty(slot);
  } else {
    put_done(*longest->control.sending);
  }
}

// Withdrawing.

void Mail::drop(Slot& slot) {
  run_.record_drop(index(slot), in_trace(slot.serial));
  empty(slot);
}

void Mail::abandon(Thread& thread) {
  for (Slot& slot : slots_) {
    if (slot.claimed == &thread) {
      slot.claimed = nullptr;
      message_available(index(slot));
    }
    withdraw(slot, &thread);
  }
}

// Devices.

void Mail::taken_by_device(Slot& slot) {
  run_.record_device(Kind::take, slot.device, index(slot), in_trace(slot.serial));
  empty(slot);
}

void Mail::request_arrives(int channel) {
  Slot& slot = at(channel);
  slot.handed = true;
  run_.hand_to_device(slot.device, slot.port, slot.fields);
}

void Mail::device_takes_request(int device) {
  Slot* oldest = nullptr;
  for (Slot& slot : slots_) {
    const bool waits = slot.full && slot.handed && slot.device == device;
    if (waits && (oldest == nullptr || slot.serial < oldest->serial)) oldest = &slot;
  }
  if (oldest != nullptr) taken_by_device(*oldest);
}

bool Mail::deliver(int channel, std::span<const double> fields) {
  Slot& slot = at(channel);
  if (discards(slot)) {
    answered_in_vain(slot);
    run_.record_device(Kind::drop, slot.device, channel, in_trace(++serials_));
    return true;
  }
  // A device that does not mark itself busy takes a request when it answers it.
  if (slot.request_of >= 0 && !run_.device_marks_itself(slot.device)) {
    Slot& request = at(slot.request_of);
    if (request.full && request.handed) taken_by_device(request);
  }
  if (slot.full) {
    answered_in_vain(slot);
    run_.overrun(slot.device, channel);
    return false;
  }
  fill(slot, fields);
  if (slot.spec->request) ask(slot, nullptr);
  slot.sender_processor = -1;
  slot.available_within = slot.available_between = run_.now();
  run_.record_device(Kind::put, slot.device, channel, in_trace(slot.serial));
  message_available(channel);
  return true;
}

}  // namespace pal::runtime
