#include "runtime/executives/real_time/real_executive.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "pal/runtime/broken_promise.hpp"
#include "runtime/executives/real_time/schedule_threads.hpp"
#include "runtime/kernel/thrown.hpp"

namespace pal::runtime {
namespace {

constexpr std::size_t queue_room = 4096;
// The limit of statements without hand-written code that follow one another before others get the kernel.
constexpr std::uint32_t most_statements_inside = 16;
// The limit of statements that take no time by the environment and follow one another without a wait.
constexpr std::uint32_t most_statements_without_time = 100'000;
// A world that is apart is moved by this time in each step.
constexpr Time stride = std::chrono::milliseconds(10);

}  // namespace

RealExecutive::RealExecutive(Clock& clock, Journal& journal, World& world, const Wiring& wiring,
                             const RunOptions& options)
    : Executive(clock),
      journal_(journal),
      world_(world),
      wiring_(wiring),
      options_(options),
      queue_(queue_room),
      levels_(clock, journal, wiring) {
  called_.reserve(levels_.all().size());
  arriving_.reserve(wiring.channels.size());
  report_.statements.resize(wiring.statements.size());
}

// What is asked from inside.

Ticket RealExecutive::at(Time when, Due due) {
  static constexpr Event::Kind kinds[] = {Event::Kind::message_available, Event::Kind::wait_expired,
                                          Event::Kind::request_arrives};
  const std::uint64_t number = queue_.push(when, kinds[static_cast<std::size_t>(due.kind)], due.subject);
  if (due.kind == Due::Kind::request_arrives && when <= now()) {
    arriving_.push_back(number);
  } else if (when < timer_.until) {
    wake(timer_);
  }
  return {number};
}

void RealExecutive::cancel(Ticket ticket) {
  std::erase(arriving_, ticket.number);
  queue_.cancel(ticket.number);
}

Ticket RealExecutive::at(Time when, int device, std::function<void()> action) {
  if (when < timer_.until) wake(timer_);
  return {queue_.push_action(when, device, std::move(action))};
}

void RealExecutive::post(int device, std::function<void()> action) {
  if (lock_.mine()) {
    at(now(), device, std::move(action));
    return;
  }
  enter();
  if (!journal_.over()) kernel_->act(device, action);
  exit();
}

// Going in and out.

void RealExecutive::enter() {
  look_at_clock(lock_.lock());
  if (moving_ && !journal_.over()) advance_world();
}

/// After the end time stands still: devices that are being closed read it without the lock.
void RealExecutive::look_at_clock(Time monotonic) {
  if (!journal_.over()) set(std::max(now(), monotonic - origin_));
}

void RealExecutive::advance_world() {
  try {
    world_.advance_to(now());
  } catch (...) {
    journal_.fail("the world: " + what_was_thrown());
  }
}

/// Every thread that can comes to its next statement. Processors are given to the threads that should have
/// them.
void RealExecutive::go_on() {
  kernel_->settle();
  if (!arriving_.empty()) let_arrive();
  if (!journal_.over()) levels_.dispatch(called_);
}

/// A request reaches its device at the instant at which it was put: the thread that asks hands it over. The
/// thread that keeps time would come later. What was due before goes before.
void RealExecutive::let_arrive() {
  while (!arriving_.empty() && !journal_.over()) {
    happen(pop());
    kernel_->settle();
  }
}

Event RealExecutive::pop() {
  const Event event = queue_.pop();
  if (!arriving_.empty()) std::erase(arriving_, event.order);
  return event;
}

/// The level's next statement follows without leaving the kernel, unless a thread is to be woken or it has
/// been in for long.
void RealExecutive::go_on_inside(Level& level) {
  const bool none_called = called_.empty() && !timer_.called && !world_alarm_.called;
  if (none_called && ++level.inside < most_statements_inside) {
    look_at_clock(monotonic_now());
    return;
  }
  exit();
  level.inside = 0;
  enter();
}

void RealExecutive::exit() {
  go_on();
  if (journal_.over() && !std::exchange(told_, true)) {
    for (Level& level : levels_.all())
      if (std::exchange(level.waits, false)) called_.push_back(&level.bell);
    wake(timer_);
    wake(world_alarm_);
    over_.store(true, std::memory_order_relaxed);
    if (world_.apart()) world_.wake();
  }
  if (timer_.asleep && kernel_->promises.next() < timer_.until) wake(timer_);
  if (moving_ && world_alarm_.asleep && world_.next_event() < world_alarm_.until) wake(world_alarm_);
  // Woken when the lock is free: they would only wait for it.
  std::array<Doorbell*, 16> later{};
  std::size_t count = 0;
  for (Doorbell* each : called_) {
    if (count < later.size()) {
      later[count++] = each;
    } else {
      each->ring();
    }
  }
  called_.clear();
  const bool timer = std::exchange(timer_.called, false);
  const bool world = std::exchange(world_alarm_.called, false);
  lock_.unlock();
  for (std::size_t i = 0; i < count; ++i) later[i]->ring();
  if (timer) timer_.sleeper.wake();
  if (world) world_alarm_.sleeper.wake();
}

void RealExecutive::sleep(Level& level) {
  level.waits = true;
  level.inside = 0;
  // No other work takes the CPU of a thread of SCHED_FIFO: it polls each time.
  const bool may = looks_out_ && (top_priority_.has_value() || level.look_out.pays());
  const bool looks_out = may && levels_.may_look_out(level);
  exit();
  if (looks_out) {
    level.look_out.polled(level.bell.look_out(monotonic_now() + options_.real_time->look_out, level.aside));
    level.aside.store(true, std::memory_order_relaxed);
  }
  level.bell.wait();
  enter();
  if (looks_out) levels_.looked_out(level);
}

void RealExecutive::sleep(Alarm& alarm, Time until) {
  alarm.asleep = true;
  alarm.until = until;
  exit();
  if (until == Time::max()) {
    alarm.sleeper.sleep();
  } else {
    alarm.sleeper.sleep_until(origin_ + until);
  }
  enter();
  alarm.asleep = false;
}

void RealExecutive::wake(Alarm& alarm) {
  if (std::exchange(alarm.asleep, false)) alarm.called = true;
}

// The threads.

void RealExecutive::guarded(const char* whose, const std::function<void()>& body) {
  try {
    body();
  } catch (...) {
    const std::string what = std::string(whose) + ": " + what_was_thrown();
    if (!lock_.mine()) enter();
    journal_.fail(what);
    exit();
  }
}

void RealExecutive::serve(Level& level) {
  enter();
  for (;;) {
    go_on();
    if (journal_.over()) break;
    if (level.work == nullptr) {
      sleep(level);
    } else {
      perform(level);
    }
  }
  level.work = nullptr;
  exit();
}

void RealExecutive::perform(Level& level) {
  Thread& thread = *level.work;
  const Time used = compute(level);
  go_on();
  // An interrupted thread has its effect when it has its processor again.
  while (!journal_.over() && !levels_.has_processor(level)) sleep(level);
  if (journal_.over()) return;
  if (goes_round(level)) {
    journal_.fail("the skill goes on and on without taking time" + kernel_->who_waits());
    return;
  }
  levels_.finish(level);
  kernel_->promises.took(thread, used);
  kernel_->finish(thread);
}

/// By the environment no time passes in what the level does.
bool RealExecutive::goes_round(Level& level) const {
  const auto statement = static_cast<std::size_t>(level.work->control.operation->statement());
  if (wiring_.statements[statement].cost.worst > Time::zero()) level.without_time = 0;
  return ++level.without_time > most_statements_without_time;
}

/// What was written by hand, outside the kernel: for how long it has held its processor. Of a statement
/// without it nothing is measured, because reading the processor time may take longer than the statement.
Time RealExecutive::compute(Level& level) {
  Thread& thread = *level.work;
  const int statement = thread.control.operation->statement();
  if (!thread.control.operation->by_hand()) {
    go_on_inside(level);
    if (thread.control.claimed < 0) thread.control.operation->compute();
    note(statement, Time::zero());
    return Time::zero();
  }
  const Time interrupted_before = levels_.interrupted(level);
  exit();
  std::string thrown;
  bool threw = false;
  HeldTime time;
  try {
    thread.control.operation->compute();
  } catch (...) {
    threw = true;
    thrown = what_was_thrown();
  }
  time.end();
  enter();
  const Time used = time.held(levels_.interrupted(level) - interrupted_before);
  note(statement, used);
  if (!threw && options_.work != nullptr) options_.work->worked(statement, used);
  if (threw) journal_.fail(thread, thrown);
  return used;
}

void RealExecutive::note(int statement, Time used) {
  StatementTimes& times = report_.statements[static_cast<std::size_t>(statement)];
  ++times.count;
  times.greatest = std::max(times.greatest, used);
  if (used > wiring_.statements[static_cast<std::size_t>(statement)].cost.worst) ++times.late;
}

void RealExecutive::keep_time() {
  enter();
  while (!journal_.over()) {
    const Time next = queue_.empty() ? Time::max() : queue_.next().time;
    const Time promised = kernel_->promises.due();
    if (promised <= now()) {
      kernel_->overdue();
    } else if (next <= now()) {
      happen(pop());
      exit();  // others may come in between
      enter();
    } else if (now() >= options_.horizon) {
      journal_.fail("the run is longer than its limit of " + in_words(options_.horizon) +
                    kernel_->who_waits());
    } else {
      sleep(timer_, std::min({next, promised, options_.horizon}));
    }
  }
  exit();
}

void RealExecutive::happen(const Event& event) {
  switch (event.kind) {
    case Event::Kind::message_available:
      kernel_->happen({Due::Kind::message_available, event.subject});
      break;
    case Event::Kind::wait_expired:
      kernel_->happen({Due::Kind::wait_expired, event.subject});
      break;
    case Event::Kind::request_arrives:
      kernel_->happen({Due::Kind::request_arrives, event.subject});
      break;
    case Event::Kind::device_action: {
      const DeviceAction taken = queue_.take_action(event);
      kernel_->act(taken.device, taken.action);
      break;
    }
    case Event::Kind::work_done:  // of virtual time
      break;
  }
}

/// From outside.
void RealExecutive::move_apart() {
  for (Time reached{}; !over_.load(std::memory_order_relaxed);) {
    const Time begun = monotonic_now();
    const Time target = begun - origin_;
    reached = std::min(target, reached + stride);
    in_world_.store(begun.count(), std::memory_order_relaxed);
    world_.advance_to(reached);
    const Time beat = world_.beat();
    const Time next = std::min(world_.next_event(), beat == Time::max() ? beat : target + beat);
    in_world_.store(0, std::memory_order_relaxed);
    if (reached < target) continue;
    waits_until_.store(next == Time::max() ? 0 : (origin_ + next).count(), std::memory_order_relaxed);
    world_.wait_until(next);
    waits_until_.store(0, std::memory_order_relaxed);
  }
}

void RealExecutive::move_world() {
  enter();
  while (!journal_.over()) {
    const Time beat = world_.beat();
    sleep(world_alarm_,
          moving_ ? std::min(world_.next_event(), beat == Time::max() ? beat : now() + beat) : Time::max());
  }
  exit();
}

// The run.

void RealExecutive::run(Kernel& kernel) {
  kernel_ = &kernel;
  moving_ = !world_.apart() && (world_.beat() != Time::max() || world_.next_event() != Time::max());
  origin_ = lock_.lock();
  std::optional<LockedMemory> memory;
  try {
    start_threads();
    // After the threads: a limit of locked memory must not keep the system from making them.
    memory.emplace(options_.real_time->lock_memory);
    if (!memory->problem().empty())
      report_.shortcomings.push_back("memory is not locked (" + memory->problem() +
                                     "): a page that is not there yet is fetched while a statement runs");
    looks_out_ = wiring_.processors.size() <= permitted_cpus().size();
    if (options_.real_time->fifo)
      top_priority_ = schedule_threads(wiring_, levels_, threads_, report_.shortcomings);
    const ScopedFifo urgent(top_priority_ ? *top_priority_ + 2 : 0);
    start_watchdog();  // devices are attached and the skill started under its eyes
    // The run's time begins when nothing is left to be made: the stack of a thread takes part of a
    // millisecond now that memory is locked.
    origin_ = monotonic_now();
    kernel.start();
    starting_.store(false, std::memory_order_relaxed);
    lock_.measure_from_now();  // until here no other thread had anything to do
    exit();
    guarded("the world", [this] { world_.apart() ? move_apart() : move_world(); });
    in_world_.store(0, std::memory_order_relaxed);
    wait_for_levels();
  } catch (...) {
    // Those threads that there are find the run over.
    if (!lock_.mine()) enter();
    journal_.fail("the run: " + what_was_thrown());
    exit();
  }
  threads_.clear();
}

void RealExecutive::close_devices(Kernel& kernel) {
  in_closing_.store(monotonic_now().count(), std::memory_order_relaxed);
  kernel.devices.close();
  in_closing_.store(0, std::memory_order_relaxed);
  watchdog_.wake();
  dog_.reset();
  report_.longest_hold = lock_.longest();
  report_.holds = lock_.holds();
}

void RealExecutive::start_threads() {
  threads_.push_back(
      std::make_unique<OsThread>("pal time", [this] { guarded("keeping time", [this] { keep_time(); }); }));
  for (Level& level : levels_.all()) {
    const std::string name = std::string(wiring_.processors[static_cast<std::size_t>(level.processor)].name) +
                             " " + std::to_string(level.priority);
    threads_.push_back(std::make_unique<OsThread>(name, [this, &level] {
      guarded("a level", [this, &level] { serve(level); });
      ended_.wake();
    }));
    level.os_thread = threads_.back()->handle();
  }
}

}  // namespace pal::runtime
