#include "runtime/real_time/real_executive.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "pal/runtime/broken_promise.hpp"
#include "runtime/thrown.hpp"

namespace pal::runtime {
namespace {

constexpr std::size_t queue_room = 4096;
// SCHED_FIFO has 1 to 99. Below: what else is urgent on the machine. Above: time, the world, the watchdog.
constexpr int least_fifo = 10;
constexpr int most_priorities = 80;

}  // namespace

RealExecutive::RealExecutive(Clock& clock, Journal& journal, World& world, const Wiring& wiring,
                             const RunOptions& options)
    : Executive(clock),
      journal_(journal),
      world_(world),
      wiring_(wiring),
      options_(options),
      queue_(queue_room),
      levels_(journal, wiring) {
  woken_.reserve(levels_.all().size() + 2);
  report_.statements.resize(wiring.statements.size());
}

// What is asked from inside.

Ticket RealExecutive::at(Time when, Due due) {
  static constexpr Event::Kind kinds[] = {Event::Kind::message_available, Event::Kind::wait_expired,
                                          Event::Kind::request_arrives};
  if (when < timer_.until) wake(timer_);
  return {queue_.push(when, kinds[static_cast<std::size_t>(due.kind)], due.subject)};
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
  const Time since = lock_.lock();
  set(std::max(now(), since - origin_));
  if (moving_ && !journal_.over()) advance_world();
}

void RealExecutive::advance_world() {
  try {
    world_.advance_to(now());
  } catch (...) {
    journal_.fail("the world: " + what_was_thrown());
  }
}

/// Everybody who can comes to the next statement, and processors are given to those who should have them.
void RealExecutive::go_on() {
  kernel_->settle();
  if (!journal_.over()) levels_.dispatch(woken_);
}

void RealExecutive::exit() {
  go_on();
  if (journal_.over() && !std::exchange(told_, true)) {
    for (Level& level : levels_.all())
      if (std::exchange(level.asleep, false)) woken_.push_back(&level.sleeper);
    wake(timer_);
    wake(world_alarm_);
  }
  if (timer_.asleep && kernel_->promises.next() < timer_.until) wake(timer_);
  if (moving_ && world_alarm_.asleep && world_.next_event() < world_alarm_.until) wake(world_alarm_);
  // Woken when the lock is free: they would only wait for it.
  std::array<Sleeper*, 16> later{};
  std::size_t count = 0;
  for (Sleeper* each : woken_) {
    if (count < later.size()) {
      later[count++] = each;
    } else {
      each->wake();
    }
  }
  woken_.clear();
  lock_.unlock();
  for (std::size_t i = 0; i < count; ++i) later[i]->wake();
}

void RealExecutive::sleep(Level& level) {
  level.asleep = true;
  exit();
  level.sleeper.sleep();
  enter();
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
  if (std::exchange(alarm.asleep, false)) woken_.push_back(&alarm.sleeper);
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
  Time used{};
  if (thread.control.claimed >= 0) {  // takes a message: nothing of it was written by hand
    set(std::max(now(), monotonic_now() - origin_));
    note(thread.control.operation->statement(), Time::zero());
  } else {
    used = compute(thread);
  }
  go_on();
  // Whoever was interrupted has its effect when it has its processor again.
  while (!journal_.over() && !levels_.has_processor(level)) sleep(level);
  if (journal_.over()) return;
  levels_.finish(level);
  kernel_->promises.took(thread, used);
  kernel_->finish(thread);
}

/// What was written by hand, outside the kernel.
Time RealExecutive::compute(Thread& thread) {
  const int statement = thread.control.operation->statement();
  const bool by_hand = thread.control.operation->by_hand();
  exit();
  const Time begun = thread_time();
  std::string thrown;
  bool threw = false;
  try {
    thread.control.operation->compute();
  } catch (...) {
    threw = true;
    thrown = what_was_thrown();
  }
  const Time used = thread_time() - begun;
  if (by_hand && !threw && options_.work != nullptr) options_.work->worked(statement, used);
  enter();
  note(statement, used);
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
      kernel_->promises.overdue();
    } else if (next <= now()) {
      happen(queue_.pop());
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
  moving_ = world_.beat() != Time::max() || world_.next_event() != Time::max();
  const LockedMemory memory(options_.real_time->lock_memory);
  if (!memory.problem().empty())
    report_.shortcomings.push_back("memory is not locked (" + memory.problem() +
                                   "): a page that is not there yet is fetched while a statement runs");
  origin_ = lock_.lock();
  try {
    start_threads();
    const int top = schedule();
    const ScopedFifo urgent(fifo_ ? top + 2 : 0);
    origin_ = monotonic_now();
    kernel.start();
    exit();
    start_watchdog(top + 3);
    guarded("the run", [this] { move_world(); });
    wait_for_levels();
  } catch (...) {
    // Those threads that there are find the run over.
    if (!lock_.mine()) enter();
    journal_.fail("the run: " + what_was_thrown());
    exit();
  }
  threads_.clear();
  watchdog_.wake();
  dog_.reset();
  report_.longest_hold = lock_.longest();
  report_.holds = lock_.holds();
}

void RealExecutive::start_threads() {
  threads_.push_back(
      std::make_unique<OsThread>([this] { guarded("keeping time", [this] { keep_time(); }); }));
  for (Level& level : levels_.all()) {
    threads_.push_back(std::make_unique<OsThread>([this, &level] {
      guarded("a level", [this, &level] { serve(level); });
      ended_.wake();
    }));
    level.os_thread = threads_.back()->handle();
  }
}

/// Gives the threads their CPUs and priorities, as far as the system permits. The greatest priority of a
/// level.
int RealExecutive::schedule() {
  std::vector<int> priorities;
  for (const ThreadSpec& thread : wiring_.threads) priorities.push_back(thread.priority);
  std::sort(priorities.begin(), priorities.end());
  priorities.erase(std::unique(priorities.begin(), priorities.end()), priorities.end());
  if (!options_.real_time->fifo) return 0;
  std::vector<std::string>& lacking = report_.shortcomings;

  const std::vector<int> cpus = permitted_cpus();
  const auto cpu_of = [&cpus](int processor) {  // the last ones first: the first one serves interrupts
    return cpus[cpus.size() - 1 - static_cast<std::size_t>(processor) % cpus.size()];
  };
  if (wiring_.processors.size() > cpus.size())
    lacking.push_back(std::to_string(wiring_.processors.size()) + " processors share " +
                      std::to_string(cpus.size()) + (cpus.size() == 1 ? " CPU" : " CPUs"));
  for (const Level& level : levels_.all()) {
    const std::string problem = pin(level.os_thread, cpu_of(level.processor));
    if (problem.empty()) continue;
    lacking.push_back("a processor is not kept on one CPU (" + problem + ")");
    break;
  }

  if (priorities.size() > most_priorities) {
    lacking.push_back("the skill has " + std::to_string(priorities.size()) +
                      " priorities; SCHED_FIFO tells the greatest " + std::to_string(most_priorities) +
                      " apart");
    priorities.erase(priorities.begin(), priorities.end() - most_priorities);
  }
  const auto rank = [&priorities](int priority) {
    const auto at = std::lower_bound(priorities.begin(), priorities.end(), priority);
    return least_fifo + static_cast<int>(at - priorities.begin());
  };
  const int top = least_fifo + most_priorities - 1;
  std::string problem = make_fifo(threads_.front()->handle(), top + 1);
  for (const Level& level : levels_.all())
    if (problem.empty()) problem = make_fifo(level.os_thread, rank(level.priority));
  fifo_ = problem.empty();
  if (fifo_) return top;
  for (const auto& thread : threads_) make_ordinary(thread->handle());
  lacking.push_back("SCHED_FIFO is not permitted (" + problem +
                    "): the system may run other work, or a thread of less priority, first");
  return 0;
}

}  // namespace pal::runtime
