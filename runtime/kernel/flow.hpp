// The coroutines of threads: beginning, blocking, going on.
#pragma once

#include <vector>

#include "pal/runtime/executive.hpp"
#include "pal/runtime/skill.hpp"
#include "pal/runtime/thread.hpp"
#include "runtime/kernel/journal.hpp"

namespace pal::runtime {

class Flow {
 public:
  Flow(Executive& executive, Journal& journal, Skill& skill);

  /// A coroutine of the thread begins, and comes to its first statement.
  void begin(Thread& thread);
  /// The thread waits without a processor.
  void block(Thread& thread, int subject);
  /// The effect of the thread's statement has taken place; its coroutine goes on at this instant.
  void proceed(Thread& thread) {
    thread.control.resuming = true;
    resuming_.push_back(&thread);
  }

  /// Lets the coroutines that may go on do so, one after the other: `go_on` resumes or stops one. Reaching a
  /// statement happens together with what leads to it, so a thread that is set going goes on before the
  /// others do.
  template <class GoOn>
  void settle(GoOn go_on) {
    while (!resuming_.empty() && !journal_.over()) {
      Thread& thread = *resuming_.front();
      const std::size_t others = resuming_.size() - 1;
      if (others == 0) {
        resuming_.clear();
      } else {
        resuming_.erase(resuming_.begin());
      }
      thread.control.resuming = false;
      go_on(thread);
      if (others > 0) put_last(others);
    }
  }

 private:
  void put_last(std::size_t others);

  Executive& executive_;
  Journal& journal_;
  Skill& skill_;
  std::vector<Thread*> resuming_;  // each thread at most once
};

}  // namespace pal::runtime
