// Processors in real time: a thread of the operating system for each processor and priority.
#pragma once

#include <pthread.h>

#include <atomic>
#include <cstdint>
#include <deque>
#include <vector>

#include "pal/runtime/thread.hpp"
#include "runtime/executives/ready_queue.hpp"
#include "runtime/executives/real_time/doorbell.hpp"
#include "runtime/executives/real_time/look_out.hpp"
#include "runtime/kernel/journal.hpp"

namespace pal::runtime {

/// One thread of the operating system, and the statement that it is at. A processor that is not preemptive
/// has one level for all priorities.
struct Level {
  int processor = 0;
  int priority = 0;  // of PAL; the greatest, where it is for all
  Doorbell bell;
  LookOut look_out;
  bool waits = false;               // at its bell
  std::atomic<bool> aside = false;  // another level of its processor has work: it is not to poll
  Thread* work = nullptr;           // whose statement it has begun and not finished
  pthread_t os_thread{};            // once it runs
  std::uint32_t inside = 0;         // statements since it came into the kernel
  std::uint32_t without_time = 0;   // statements since it waited or took time
  std::uint32_t ticks = 0;          // of the watchdog, while that statement had its processor
  Time interrupted{};               // how long that statement was without its processor
  Time since{};                     // when it lost its processor last
};

/// Gives processors to threads by the rules of docs/reference/execution-model.md, as the Scheduler of virtual
/// time does. It decides which thread begins a statement and which may have its effect. The operating system
/// makes sure that an interrupted thread does not run meanwhile.
class Levels {
 public:
  /// All outlive the levels.
  Levels(const Clock& clock, Journal& journal, const Wiring& wiring);

  /// The thread has come to a statement that needs its processor.
  void need_processor(Thread& thread);
  /// The thread blocks or ends: its processor is free for others.
  void leave(Thread& thread);
  /// Gives the processors to the threads that should have them now. Adds to `called` the bells of levels that
  /// wait and have something to do; they must be rung.
  void dispatch(std::vector<Doorbell*>& called);

  /// The level is about to wait. Whether its processor has nothing else to do: then it may poll for its
  /// next statement before it sleeps, until `aside`.
  bool may_look_out(Level& level);
  void looked_out(Level& level) {
    Level*& looks = processors_[static_cast<std::size_t>(level.processor)].looks_out;
    if (looks == &level) looks = nullptr;
  }

  /// Whether the level's statement has its processor at present.
  bool has_processor(const Level& level) const {
    return level.work != nullptr && of(*level.work).running == level.work;
  }
  /// How long the level's statement has been interrupted up to now.
  Time interrupted(const Level& level) const {
    return level.interrupted + (has_processor(level) ? Time::zero() : clock_.now - level.since);
  }
  /// The level's statement is about to have its effect.
  void finish(Level& level);
  /// No level is at work.
  bool idle() const;

  std::deque<Level>& all() { return levels_; }

 private:
  struct Processor {
    Processor(const ProcessorSpec& its, std::size_t threads) : spec(&its), ready(threads) {
      arrived.reserve(2 * threads);
    }
    const ProcessorSpec* spec;
    Thread* running = nullptr;
    bool working = false;
    ReadyQueue ready;
    std::vector<Thread*> arrived;  // became ready since the last dispatch
    bool changed = false;
    Level* looks_out = nullptr;
  };
  const Processor& of(const Thread& thread) const {
    return processors_[static_cast<std::size_t>(thread.control.spec->processor)];
  }
  Processor& of(const Thread& thread) {
    return processors_[static_cast<std::size_t>(thread.control.spec->processor)];
  }
  Level& level_of(const Thread& thread) { return *level_of_[static_cast<std::size_t>(thread.control.index)]; }
  void enqueue(Processor& processor, Thread& thread);
  void interrupt(Processor& processor);
  void start(Processor& processor, Thread& thread, std::vector<Doorbell*>& called);
  void dispatch(Processor& processor, std::vector<Doorbell*>& called);
  void announce(Processor& processor);

  const Clock& clock_;
  Journal& journal_;
  std::vector<Processor> processors_;
  std::deque<Level> levels_;
  std::vector<Level*> level_of_;  // of each thread
  std::int64_t back_ = 0;
  std::int64_t front_ = 0;
};

}  // namespace pal::runtime
