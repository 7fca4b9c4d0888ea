// Where a level waits for its next statement.
#pragma once

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>

#include "runtime/executives/real_time/clock.hpp"

namespace pal::runtime {

/// One thread waits here, others ring. Rings before the wait are not lost, and count as one. A ring costs a
/// system call only if the thread sleeps. (A futex: Drepper, Futexes Are Tricky, section 5.)
class Doorbell {
 public:
  Doorbell() = default;
  Doorbell(const Doorbell&) = delete;
  Doorbell& operator=(const Doorbell&) = delete;

  void ring() {
    if (state_.exchange(rung, std::memory_order_release) == asleep) futex(FUTEX_WAKE_PRIVATE, 1);
  }

  /// Looks for a ring until `until` (monotonic) without sleeping, unless `enough` becomes true. Whether it
  /// was rung.
  bool look_out(Time until, const std::atomic<bool>& enough) {
    for (;;) {
      if (state_.load(std::memory_order_acquire) == rung) return true;
      if (enough.load(std::memory_order_relaxed) || monotonic_now() >= until) return false;
      pause();
    }
  }

  /// Returns once it was rung.
  void wait() {
    std::uint32_t found = quiet;
    state_.compare_exchange_strong(found, asleep, std::memory_order_acquire);
    while (state_.load(std::memory_order_acquire) != rung) futex(FUTEX_WAIT_PRIVATE, asleep);
    state_.store(quiet, std::memory_order_relaxed);
  }

 private:
  static constexpr std::uint32_t quiet = 0, rung = 1, asleep = 2;

  static void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
  }
  void futex(int operation, std::uint32_t value) {
    static_assert(sizeof state_ == sizeof(std::uint32_t) && decltype(state_)::is_always_lock_free);
    ::syscall(SYS_futex, &state_, operation, value, nullptr, nullptr, 0);
  }

  std::atomic<std::uint32_t> state_ = quiet;
};

}  // namespace pal::runtime
