#include "runtime/executives/virtual_executive.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "pal/runtime/broken_promise.hpp"
#include "pal/runtime/still_world.hpp"
#include "runtime/kernel/thrown.hpp"

namespace pal::runtime {
namespace {

constexpr std::size_t queue_capacity = 4096;
// More than this at one instant is a skill that spins without taking time.
constexpr std::uint64_t most_events_at_one_instant = 1'000'000;

}  // namespace

VirtualExecutive::VirtualExecutive(Clock& clock, Journal& journal, World& world, const Wiring& wiring,
                                   const RunOptions& options)
    : Executive(clock),
      journal_(journal),
      world_(world),
      options_(options),
      straight_(options.control == nullptr && options.slow.empty() &&
                dynamic_cast<const StillWorld*>(&world) != nullptr),
      costs_(options.costs, options.seed),
      queue_(queue_capacity),
      scheduler_(clock, journal, queue_, wiring),
      wiring_(wiring),
      taken_(wiring.threads.size()) {}

// What a statement takes that was told to be slow.
Time VirtualExecutive::slowed(const Thread& thread, Time cost) {
  const StatementSpec& statement =
      wiring_.statements[static_cast<std::size_t>(thread.control.operation->statement())];
  Time& taken = taken_[static_cast<std::size_t>(thread.control.index)];
  taken = Time::zero();
  for (const SlowStatement& each : options_.slow) {
    if (each.line == statement.line && each.module == statement.module && each.from <= now())
      cost = taken = each.takes;
  }
  return cost;
}

Ticket VirtualExecutive::at(Time when, Due due) {
  static constexpr Event::Kind kinds[] = {Event::Kind::message_available, Event::Kind::wait_expired,
                                          Event::Kind::request_arrives};
  return {queue_.push(when, kinds[static_cast<std::size_t>(due.kind)], due.subject)};
}

Ticket VirtualExecutive::at(Time when, int device, std::function<void()> action) {
  return {queue_.push_action(when, device, std::move(action))};
}

void VirtualExecutive::post(int device, std::function<void()> action) {
  const std::lock_guard lock(posting_);
  posted_.push_back({device, std::move(action)});
  something_posted_.store(true, std::memory_order_release);
}

void VirtualExecutive::take_posted() {
  std::vector<DeviceAction> taken;
  {
    const std::lock_guard lock(posting_);
    taken.swap(posted_);
    something_posted_.store(false, std::memory_order_relaxed);
  }
  for (DeviceAction& each : taken) queue_.push_action(now(), each.device, std::move(each.action));
}

void VirtualExecutive::run(Kernel& kernel) {
  kernel.start();
  if (!journal_.over()) scheduler_.dispatch();
  while (!journal_.over()) {
    if (!straight_ || !go_straight_on(kernel)) step(kernel);
  }
}

/// Coroutines go on one after the other; then the processors are given to the threads that should have them.
void VirtualExecutive::settle(Kernel& kernel) {
  kernel.settle();
  if (!journal_.over()) scheduler_.dispatch();
}

/// The usual case of step(): the next event is the end of a statement, and nothing can come before it. False:
/// it is not so, and nothing has happened.
bool VirtualExecutive::go_straight_on(Kernel& kernel) {
  if (queue_.empty() || something_posted_.load(std::memory_order_acquire)) return false;
  const Event& next = queue_.next();
  const Time when = next.time;
  if (next.kind != Event::Kind::work_done || kernel.promises.next() < when) return false;
  if (when != now()) {
    if (when > options_.horizon) return false;
    set(when);
    events_now_ = 0;
  } else if (++events_now_ > most_events_at_one_instant) {
    return false;
  }
  Thread& thread = scheduler_.finish_work(next.subject);
  queue_.drop_next();
  if (kernel.compute(thread)) kernel.finish(thread);
  settle(kernel);
  return true;
}

void VirtualExecutive::fail(const char* reason, const Kernel& kernel) {
  journal_.fail(reason + kernel.who_waits());
}

bool VirtualExecutive::too_long(const Kernel& kernel) {
  set(options_.horizon);
  journal_.fail("the run is longer than its limit of " + in_words(now()) + kernel.who_waits());
  return false;
}

// Brings the clock and the world to `when`. False: the run is over, or something came in on the way.
bool VirtualExecutive::go_to(Time when, const Kernel& kernel) {
  if (when > options_.horizon) return too_long(kernel);
  try {
    const Time reached = world_.wait_until(when);
    if (reached < now())
      throw std::logic_error("wait_until() goes back, from " + in_words(now()) + " to " + in_words(reached));
    if (reached > when)
      throw std::logic_error("wait_until() goes beyond " + in_words(when) + ", to " + in_words(reached));
    if (reached > now()) events_now_ = 0;
    set(reached);
    world_.advance_to(reached);
  } catch (...) {
    journal_.fail("the world: " + what_was_thrown());
  }
  return !journal_.over() && now() == when;
}

// More than an end was asked for. Holds the run for as long as it is to be held.
void VirtualExecutive::obey(RunControl& control, Kernel& kernel) {
  const bool any = !queue_.empty();
  const Time next =
      std::min({any ? queue_.next().time : Time::max(), world_.next_event(), kernel.promises.due()});
  const Time stop = control.stop_instant();
  if (stop <= next) {
    if (stop <= now() || go_to(stop, kernel)) journal_.fail("stopped on request");
    return;
  }
  const bool effect = any && queue_.next().kind == Event::Kind::work_done && queue_.next().time == next;
  const Thread* thread = effect ? scheduler_.running(queue_.next().subject) : nullptr;
  const StatementSpec none;
  const StatementSpec& statement =
      thread == nullptr
          ? none
          : kernel.wiring.statements[static_cast<std::size_t>(thread->control.operation->statement())];
  std::string reason = control.reason_to_hold(effect ? queue_.next().order : 0, statement.module,
                                              statement.file, statement.line);
  if (reason.empty()) return;
  control.hold(
      {now(), std::move(reason), thread == nullptr ? "" : journal_.place_of(*thread), kernel.places()});
  world_.resumed();
}

// What is late before `next` is noted at its instant. False: nothing is.
bool VirtualExecutive::note_overdue(Time next, Kernel& kernel) {
  const Time due = kernel.promises.due();
  if (due >= next) return false;
  if (go_to(due, kernel)) kernel.overdue();
  return true;
}

void VirtualExecutive::step(Kernel& kernel) {
  if (options_.control != nullptr) {
    if (options_.control->watching()) obey(*options_.control, kernel);
    if (options_.control->stopping()) journal_.fail("stopped on request");
    if (journal_.over()) return;
  }
  if (something_posted_.load(std::memory_order_acquire)) take_posted();
  const Time own = queue_.empty() ? Time::max() : queue_.next().time;
  const Time in_world = world_.next_event();
  const Time next = std::min(own, in_world);
  if (kernel.promises.next() < next && note_overdue(next, kernel)) {
    settle(kernel);
    return;
  }
  if (next == Time::max()) {
    fail("nothing is left to happen", kernel);
    return;
  }
  if (++events_now_ > most_events_at_one_instant) {
    fail("the skill goes on and on without taking time", kernel);
    return;
  }
  if (in_world <= own) {  // what arrives at an instant is there before anything else happens at it
    go_to(in_world, kernel);
  } else if (own == now() || go_to(own, kernel)) {
    const Event event = queue_.pop();
    if (event.kind == Event::Kind::work_done) {
      work_done(event.subject, kernel);
    } else {
      happen(event, kernel);
    }
  }
  settle(kernel);
}

void VirtualExecutive::work_done(int processor, Kernel& kernel) {
  Thread& thread = scheduler_.finish_work(processor);
  if (!options_.slow.empty())
    kernel.promises.took(thread, taken_[static_cast<std::size_t>(thread.control.index)]);
  if (!journal_.over() && kernel.compute(thread)) kernel.finish(thread);
  if (options_.control != nullptr && options_.control->watching()) options_.control->count_statement();
}

void VirtualExecutive::happen(const Event& event, Kernel& kernel) {
  switch (event.kind) {
    case Event::Kind::work_done:
      work_done(event.subject, kernel);
      break;
    case Event::Kind::message_available:
      kernel.happen({Due::Kind::message_available, event.subject});
      break;
    case Event::Kind::wait_expired:
      kernel.happen({Due::Kind::wait_expired, event.subject});
      break;
    case Event::Kind::request_arrives:
      kernel.happen({Due::Kind::request_arrives, event.subject});
      break;
    case Event::Kind::device_action: {
      const DeviceAction taken = queue_.take_action(event);
      kernel.act(taken.device, taken.action);
      break;
    }
  }
}

}  // namespace pal::runtime
