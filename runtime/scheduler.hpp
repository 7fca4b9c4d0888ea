// The virtual processors: who runs where (docs/reference/execution-model.md, Threads and processors).
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/thread.hpp"

namespace pal::runtime {

struct Processor {
  const ProcessorSpec* spec = nullptr;
  std::vector<Thread*> threads;
  Thread* running = nullptr;
  bool working = false;  // `running` is at work on its statement, since `since`
  Time since{};
  std::uint64_t token = 0;  // names the piece of work that is going on
};

class Scheduler {
 public:
  Scheduler(Run& run, const Wiring& wiring);

  void add(Thread& thread);

  /// The thread has come to a statement that needs `time` of its processor.
  void need_processor(Thread& thread, Time time);

  /// The thread blocks or ends: its processor is free for others.
  void leave(Thread& thread);

  /// Gives the processors to those who should have them now.
  void dispatch();

  /// Whether the end of work that an event announces is still to come.
  bool expects(int processor, std::uint64_t token) const;

  /// The running thread's statement has had all of its time.
  Thread& finish_work(int processor);

 private:
  Thread* first_ready(const Processor& processor) const;
  void dispatch(Processor& processor);
  void start(Processor& processor, Thread& thread);
  void interrupt(Processor& processor);
  Processor& processor_of(const Thread& thread);

  Run& run_;
  std::vector<Processor> processors_;
  std::int64_t back_ = 0;
  std::int64_t front_ = 0;
};

}  // namespace pal::runtime
