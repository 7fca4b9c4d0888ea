// Control of a run from outside while it goes on.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pal/runtime/device.hpp"

namespace pal::runtime {

/// The place where a run is held.
struct Halt {
  Time time{};                       // of the skill
  std::string reason;                // "paused", "stepped", "breakpoint at SM1:51"
  std::string next;                  // the statement that is about to have its effect; empty: none is
  std::vector<std::string> threads;  // each with the statement that it has come to
};

/// Called from another thread; stop() also from a signal handler. The run looks before each event. The same
/// for virtual and paced runs. While a run is held its time stands still: nothing happens in the skill, its
/// devices and the physics. A run in real time can be stopped but not held, because the robot cannot wait.
class RunControl {
 public:
  /// Ends the skill with its error completion; devices are closed. This is permanent: a skill that begins
  /// afterwards is refused.
  void stop() noexcept { asked_.fetch_or(stop_bit, std::memory_order_relaxed); }
  bool stopping() const noexcept { return (asked_.load(std::memory_order_relaxed) & stop_bit) != 0; }
  /// The same at an instant of the skill's time, before anything else happens at it.
  void stop_at(Time when);

  /// Holds the run before its next event.
  void pause();
  /// Lets a held run go on.
  void resume();
  /// Lets the run go on until `statements` statements (at least one) have had their effect, then holds it
  /// again.
  void step(std::size_t statements = 1);
  /// Holds the run when a statement of `where`, a file or a module, in `line` is about to have its effect.
  void break_at(std::string where, int line);
  void clear_breakpoints();

  /// Waits until the run is held, for `limit` at most; nothing: it is not.
  std::optional<Halt> wait_for_halt(std::chrono::milliseconds limit);

  /// Why the run cannot be held: pause(), step() and breakpoints do nothing. Empty: it can.
  std::string refusal() const;

  // For the run.
  void refuse_to_hold(std::string why);
  /// Whether something other than stop() was asked for; then the run checks in detail.
  bool watching() const noexcept { return (asked_.load(std::memory_order_relaxed) & watch_bit) != 0; }
  Time stop_instant() const;
  /// A statement has had its effect.
  void count_statement();
  /// Why the run must be held before `event`, which comes next; empty: it goes on. `module`, `file` and
  /// `line` are those of the statement that then has its effect; line 0: there is none. A breakpoint holds
  /// once before an event.
  std::string reason_to_hold(std::uint64_t event, std::string_view module, std::string_view file, int line);
  /// Returns when the run may go on, or is to stop.
  void hold(Halt halt);

 private:
  static constexpr unsigned stop_bit = 1;
  static constexpr unsigned watch_bit = 2;
  struct Breakpoint {
    std::string where;
    int line = 0;
  };
  void watch();

  std::atomic<unsigned> asked_ = 0;
  static_assert(std::atomic<unsigned>::is_always_lock_free);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool paused_ = false;
  std::size_t steps_ = 0;  // still to go
  bool stepped_ = false;
  Time stop_at_ = Time::max();
  std::vector<Breakpoint> breakpoints_;
  std::string refusal_;
  std::uint64_t held_before_ = 0;  // the event
  std::optional<Halt> halt_;
};

}  // namespace pal::runtime
