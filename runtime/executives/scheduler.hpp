// The virtual processors: which of the ready threads runs where, by priority and then by order
// (docs/reference/execution-model.md, Threads and processors).
#pragma once

#include <cstdint>
#include <vector>

#include "pal/runtime/thread.hpp"
#include "runtime/executives/event_queue.hpp"
#include "runtime/executives/ready_queue.hpp"
#include "runtime/kernel/journal.hpp"

namespace pal::runtime {

struct Processor {
  Processor(const ProcessorSpec& its, int number, std::size_t threads)
      : spec(&its), index(number), ready(threads) {
    arrived.reserve(2 * threads);
  }
  const ProcessorSpec* spec;
  int index;
  Thread* running = nullptr;
  bool working = false;  // `running` is at work on its statement, since `since`
  Time since{};
  std::uint64_t end = 0;  // names the event at which the work will be done
  ReadyQueue ready;
  std::vector<Thread*> arrived;  // became ready since the last dispatch
  bool changed = false;          // a thread came or went
};

class Scheduler {
 public:
  /// All outlive the scheduler.
  Scheduler(const Clock& clock, Journal& journal, EventQueue& queue, const Wiring& wiring);

  /// The thread has come to a statement that needs `time` of its processor.
  void need_processor(Thread& thread, Time time);

  /// The thread blocks or ends: its processor is free for others.
  void leave(Thread& thread);

  /// Gives the processors to the threads that should have them now.
  void dispatch();

  /// The thread that has the processor; null: none.
  const Thread* running(int processor) const {
    return processors_[static_cast<std::size_t>(processor)].running;
  }

  /// The running thread's statement has had all of its time.
  Thread& finish_work(int processor);

 private:
  void dispatch(Processor& processor);
  [[gnu::noinline]] void dispatch_all();
  void start(Processor& processor, Thread& thread);
  void start_first(Processor& processor);
  void interrupt(Processor& processor);
  void enqueue(Processor& processor, Thread& thread);
  void announce(Processor& processor);
  void note_change(Processor& processor);
  Processor& processor_of(const Thread& thread) {
    return processors_[static_cast<std::size_t>(thread.control.spec->processor)];
  }

  const Clock& clock_;
  Journal& journal_;
  EventQueue& queue_;
  std::vector<Processor> processors_;
  std::vector<Processor*> changed_;  // has room for all
  std::size_t changes_ = 0;          // how many of it have changed
  std::int64_t back_ = 0;
  std::int64_t front_ = 0;
};

}  // namespace pal::runtime
