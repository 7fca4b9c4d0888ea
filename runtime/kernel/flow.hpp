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
    set_going_[going_++] = &thread;
  }

  /// Lets the coroutines that may go on do so, one after the other: `go_on` resumes or stops one. Reaching a
  /// statement happens together with what leads to it, so a thread that is set going goes on before the
  /// others do.
  template <class GoOn>
  void settle(GoOn go_on) {
    while (!journal_.over()) {
      if (going_ > 1) [[unlikely]]
        put_others_back();
      if (going_ == 0 && waiting_ == 0) return;
      Thread& thread = going_ > 0 ? *set_going_[--going_] : *resuming_[--waiting_];
      thread.control.resuming = false;
      go_on(thread);
    }
  }

 private:
  /// All that were set going but the first wait, the second one the last of them.
  [[gnu::noinline]] void put_others_back() {
    while (going_ > 1) resuming_[waiting_++] = set_going_[--going_];
  }

  Executive& executive_;
  Journal& journal_;
  Skill& skill_;
  // Each thread is there at most once, so each has room for all.
  std::vector<Thread*> set_going_;       // since a thread went on last, in this order
  std::vector<Thread*> resuming_;        // the last one goes on next
  std::size_t going_ = 0, waiting_ = 0;  // how many there are
};

}  // namespace pal::runtime
