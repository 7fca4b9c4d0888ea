// The common part of all runs, whatever gives them time: operations, mail, conditions, blocks, devices.
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "pal/runtime/executive.hpp"
#include "pal/runtime/skill.hpp"
#include "pal/runtime/thread.hpp"
#include "runtime/kernel/blocks.hpp"
#include "runtime/kernel/conditions.hpp"
#include "runtime/kernel/devices.hpp"
#include "runtime/kernel/flow.hpp"
#include "runtime/kernel/frame_pool.hpp"
#include "runtime/kernel/journal.hpp"
#include "runtime/kernel/mail.hpp"
#include "runtime/kernel/promises.hpp"
#include "runtime/watch/held_time.hpp"

namespace pal::runtime {

/// Not thread-safe: no two of its functions may run at once.
class Kernel {
 public:
  /// All outlive the kernel. `connections`: one for each device of the skill's wiring, in its order.
  Kernel(const Clock& clock, Executive& executive, Journal& journal, Skill& skill,
         const std::vector<Connection>& connections, const RunOptions& options);
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;

  // For executives.
  /// All threads come to their first statement, unless the run is over before.
  void start();
  /// An event that was asked for by Executive::at() is due.
  void happen(Due due);
  /// Time has reached promises.due(): what is late is noted; what has no answer any more is open no more.
  void overdue() {
    for (const int device : promises.overdue()) mail.late(device);
  }
  void act(int device, const std::function<void()>& action) { devices.act(device, action); }
  /// The thread's statement has had its processor: its effect happens. compute() has run before.
  void finish(Thread& thread) {
    try {
      thread.control.operation->effect();
    } catch (...) {
      journal.fail_by_exception(thread);
    }
  }
  /// Runs the hand-written code of the thread's statement; changes nothing in the kernel. False: it has
  /// thrown, and finish() is not called.
  bool compute(Thread& thread) {
    try {
      Operation& operation = *thread.control.operation;
      if (work_ == nullptr || !operation.by_hand()) {
        operation.compute();
        return true;
      }
      HeldTime time;
      operation.compute();
      time.end();
      work_->worked(operation.statement(), time.held());
      return true;
    } catch (...) {
      journal.fail_by_exception(thread);
      return false;
    }
  }
  /// Threads whose statement had its effect go on to their next one. To be called after every event.
  void settle() {
    flow.settle([this](Thread& thread) {
      if (thread.control.cancelled) {
        blocks.stop(thread);
      } else {
        thread.control.resume_point.resume();
      }
    });
  }
  /// Of each thread that has begun and not ended: "SM1 at TXM( x to y ) (file.pal:7)".
  std::vector<std::string> places() const;
  /// ": SM1 at …, MC1 at …"
  std::string who_waits() const;
  /// Whether a thread waits for a message of a device, or for one to take its message.
  bool awaits_device() const;

  // For the statements of threads.
  Executive& executive;
  Journal& journal;
  Promises promises;
  FramePool frames;
  Flow flow;
  Mail mail;
  Blocks blocks;
  Conditions conditions;
  Devices devices;
  const Wiring& wiring;

 private:
  Skill& skill_;
  WorkObserver* work_;  // null: none
  std::deque<Thread> threads_;
};

}  // namespace pal::runtime
