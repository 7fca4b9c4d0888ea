// Real time: the options of a run by the wall clock, and its report.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pal/runtime/device.hpp"

namespace pal::runtime {

/// How a run goes in real time (RunOptions::real_time). If the system does not permit something, it is left
/// out, and the report says so.
struct RealTime {
  /// Asks for SCHED_FIFO, and pins the threads of each processor to one CPU.
  bool fifo = true;
  /// Locks all memory of the process from the beginning of the run to its end. A process that has locked its
  /// memory itself says false: the end of the run would unlock it.
  bool lock_memory = true;
  /// A thread that waits polls for its next statement for this time before it sleeps, because waking up may
  /// take longer than an answer. It does so only if each processor has a CPU of its own, and only while no
  /// other level of its processor has work; without SCHED_FIFO, only while it pays. 0: it sleeps at once.
  Time look_out = std::chrono::microseconds(100);
  /// What the environment declares of devices is watched with this much to spare: an answer may come so much
  /// sooner or later, an event with so much more jitter. Frames have none. It is what the clocks and threads
  /// of this machine add to devices that keep their times. The proof counts only if it holds with it, too.
  Time tolerance{};
  /// A statement whose time is a COST of the environment may take so much longer. It is what the interrupts
  /// of this machine add to its processor time: an activity's declared time has room for them, that of a send
  /// has little. The proof counts only if it holds with it, too.
  Time cost_tolerance{};
  /// Code that exceeds its declared worst time by this much of its processor is taken as never returning. The
  /// devices are closed, and the process ends, because C++ can end a thread in no other way.
  Time hang_timeout = std::chrono::seconds(1);
  /// The exit status of the process in that case.
  int hang_status = 70;
};

/// What was measured of one statement: for how long what was written by hand has held its processor. That is
/// its processor time; if it slept or waited, the time on the wall, without interruptions by other threads of
/// the skill.
struct StatementTimes {
  std::size_t count = 0;
  Time greatest{};
  std::size_t late = 0;  // times beyond the declared worst
};

/// Of a run in real time.
struct RealTimeReport {
  /// Where the run was not fully real time, each in words: "SCHED_FIFO is not permitted …". Empty: nowhere.
  std::vector<std::string> shortcomings;
  /// The longest time for which one thread held the kernel, and how often it was taken.
  Time longest_hold{};
  std::uint64_t holds = 0;
  /// One for each statement of the wiring.
  std::vector<StatementTimes> statements;
};

}  // namespace pal::runtime
