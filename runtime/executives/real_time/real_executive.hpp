// Real time: threads of the operating system, and the wall clock.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pal/runtime/executive.hpp"
#include "pal/runtime/outcome.hpp"
#include "runtime/executives/event_queue.hpp"
#include "runtime/executives/real_time/kernel_lock.hpp"
#include "runtime/executives/real_time/levels.hpp"
#include "runtime/executives/real_time/os_thread.hpp"
#include "runtime/kernel/journal.hpp"
#include "runtime/kernel/kernel.hpp"

namespace pal::runtime {

/// Runs a skill with threads of the operating system. The most urgent is the watchdog. Then come one that
/// keeps time, the caller's own, which moves the world, and one for each level. Hand-written code runs
/// without the kernel's lock, everything else with it.
class RealExecutive final : public Executive {
 public:
  /// All outlive the executive. `options.real_time` is there.
  RealExecutive(Clock& clock, Journal& journal, World& world, const Wiring& wiring,
                const RunOptions& options);

  /// Runs the skill from its start to its end. If some code does not return, ends the process instead.
  void run(Kernel& kernel);
  /// The run is over. If closing does not return, ends the process.
  void close_devices(Kernel& kernel);
  /// Of a run that is over, its devices closed.
  RealTimeReport take_report() { return std::move(report_); }

  /// There is no latency but that of the machine.
  Time latency(const Interval&) override { return Time::zero(); }
  void need_processor(Thread& thread, const Interval&) override { levels_.need_processor(thread); }
  void leave(Thread& thread) override { levels_.leave(thread); }
  Ticket at(Time when, Due due) override;
  Ticket at(Time when, int device, std::function<void()> action) override;
  void cancel(Ticket ticket) override;
  /// Called from outside the run, it returns after the action was called.
  void post(int device, std::function<void()> action) override;

 private:
  /// A thread sleeps until an instant of the run; another thread may need it sooner.
  struct Alarm {
    Sleeper sleeper;
    bool asleep = false;
    bool called = false;  // is to be woken when the kernel is free
    Time until{};
  };

  // What each of the threads does.
  void serve(Level& level);
  void keep_time();
  void move_world();
  void move_apart();
  void watch();
  void guarded(const char* whose, const std::function<void()>& body);

  // The kernel: one thread at a time is inside.
  void enter();
  void exit();
  void look_at_clock(Time monotonic);
  void go_on();
  void let_arrive();
  Event pop();
  void go_on_inside(Level& level);
  void sleep(Level& level);
  void sleep(Alarm& alarm, Time until);
  void wake(Alarm& alarm);
  void advance_world();

  void perform(Level& level);
  Time compute(Level& level);
  void happen(const Event& event);
  void note(int statement, Time used);

  // The watchdog.
  void look();
  void look_for_deadlock();
  [[noreturn]] void end_process(const std::string& why);
  void look_for_hangs();
  bool goes_round(Level& level) const;
  void wait_for_levels();

  void start_threads();
  void start_watchdog();

  Journal& journal_;
  World& world_;
  const Wiring& wiring_;
  RunOptions options_;
  Kernel* kernel_ = nullptr;
  KernelLock lock_;
  EventQueue queue_;
  std::vector<std::uint64_t> arriving_;  // of the queue: requests that reach their devices now
  Levels levels_;
  std::vector<Doorbell*> called_;  // are to be rung when the kernel is free
  Alarm timer_, world_alarm_;
  Sleeper ended_, watchdog_, closed_;
  // Since when they are called without the lock (monotonic); 0: they are not.
  std::atomic<Time::rep> in_world_ = 0, in_closing_ = 0;
  std::atomic<bool> starting_ = true;       // devices are being attached, and the skill started
  std::atomic<Time::rep> waits_until_ = 0;  // the world, apart; monotonic, 0: it does not wait
  std::atomic<bool> over_ = false;          // as a world that is apart sees it
  Time origin_{};
  bool moving_ = false;  // something moves in the world by itself, with the lock
  bool told_ = false;    // all threads have been woken for the end
  std::atomic<bool> hung_ = false;
  std::optional<int> top_priority_;  // of a level, if SCHED_FIFO is permitted and wanted
  bool looks_out_ = false;           // each processor has a CPU of its own
  std::vector<std::unique_ptr<OsThread>> threads_;
  std::unique_ptr<OsThread> dog_;
  RealTimeReport report_;
};

}  // namespace pal::runtime
