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
    set_going_.push_back(&thread);
  }

  /// Lets the coroutines that may go on do so, one after the other: `go_on` resumes or stops one. Reaching a
  /// statement happens together with what leads to it, so a thread that is set going goes on before the
  /// others do.
  template <class GoOn>
  void settle(GoOn go_on) {
    while (!journal_.over()) {
      for (; !set_going_.empty(); set_going_.pop_back()) resuming_.push_back(set_going_.back());
      if (resuming_.empty()) return;
      Thread& thread = *resuming_.back();
      resuming_.pop_back();
      thread.control.resuming = false;
      go_on(thread);
    }
  }

 private:
  Executive& executive_;
  Journal& journal_;
  Skill& skill_;
  // Each thread at most once.
  std::vector<Thread*> set_going_;  // since a thread went on last, in this order
  std::vector<Thread*> resuming_;   // the last one goes on next
};

}  // namespace pal::runtime
