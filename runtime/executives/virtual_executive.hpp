// Virtual time: a discrete-event executive, single-threaded and deterministic.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

#include "pal/runtime/cost_policy.hpp"
#include "pal/runtime/executive.hpp"
#include "runtime/executives/event_queue.hpp"
#include "runtime/executives/scheduler.hpp"
#include "runtime/kernel/journal.hpp"
#include "runtime/kernel/kernel.hpp"

namespace pal::runtime {

class VirtualExecutive final : public Executive {
 public:
  /// All outlive the executive.
  VirtualExecutive(Clock& clock, Journal& journal, World& world, const Wiring& wiring,
                   const RunOptions& options);

  /// From the start of the skill to its end.
  void run(Kernel& kernel);
  /// The run is over.
  static void close_devices(Kernel& kernel) { kernel.devices.close(); }

  Time latency(const Interval& interval) override { return costs_.draw(interval); }
  void need_processor(Thread& thread, const Interval& time) override {
    const Time cost = costs_.draw(time);
    scheduler_.need_processor(thread, options_.slow.empty() ? cost : slowed(thread, cost));
  }
  void leave(Thread& thread) override { scheduler_.leave(thread); }
  Ticket at(Time when, Due due) override;
  Ticket at(Time when, int device, std::function<void()> action) override;
  void cancel(Ticket ticket) override { queue_.cancel(ticket.number); }
  void post(int device, std::function<void()> action) override;

 private:
  bool go_straight_on(Kernel& kernel);
  void step(Kernel& kernel);
  void settle(Kernel& kernel);
  bool note_overdue(Time next, Kernel& kernel);
  Time slowed(const Thread& thread, Time cost);
  void obey(RunControl& control, Kernel& kernel);
  bool go_to(Time when, const Kernel& kernel);
  void happen(const Event& event, Kernel& kernel);
  void work_done(int processor, Kernel& kernel);
  // What ends a run: apart from what goes on all the time.
  [[gnu::cold]] void fail(const char* reason, const Kernel& kernel);
  [[gnu::cold]] bool too_long(const Kernel& kernel);
  void take_posted();

  Journal& journal_;
  World& world_;
  RunOptions options_;
  bool straight_;  // only events of the queue, and what is overdue, move the run
  CostDraw costs_;
  EventQueue queue_;
  Scheduler scheduler_;
  const Wiring& wiring_;
  std::vector<Time> taken_;       // by thread: of its processor, by a statement that is slowed; 0: of no such
  std::uint64_t events_now_ = 0;  // since time last went on
  std::atomic<bool> something_posted_ = false;
  std::mutex posting_;
  std::vector<DeviceAction> posted_;
};

}  // namespace pal::runtime
