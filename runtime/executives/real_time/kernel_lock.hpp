// The one lock of a run in real time.
#pragma once

#include <pthread.h>

#include <atomic>
#include <cstdint>

#include "runtime/executives/real_time/clock.hpp"

namespace pal::runtime {

/// A mutex with priority inheritance: its holder gets the priority of the most urgent thread that waits for
/// it. It measures how long it was held.
class KernelLock {
 public:
  /// Throws std::system_error if the system has no such mutex.
  KernelLock();
  ~KernelLock() { ::pthread_mutex_destroy(&mutex_); }
  KernelLock(const KernelLock&) = delete;
  KernelLock& operator=(const KernelLock&) = delete;

  /// The instant from which it is held (monotonic).
  Time lock() {
    ::pthread_mutex_lock(&mutex_);
    return taken();
  }
  bool try_lock() {
    if (::pthread_mutex_trylock(&mutex_) != 0) return false;
    taken();
    return true;
  }
  void unlock() {
    const Time held = monotonic_now() - Time(since_.load(std::memory_order_relaxed));
    if (held > longest_) longest_ = held;
    ++holds_;
    since_.store(0, std::memory_order_relaxed);
    owner_.store({}, std::memory_order_relaxed);
    ::pthread_mutex_unlock(&mutex_);
  }

  /// While it is held: the hold is measured from now on.
  void measure_from_now() { since_.store(monotonic_now().count(), std::memory_order_relaxed); }

  /// Whether the calling thread has it.
  bool mine() const { return owner_.load(std::memory_order_relaxed) == ::pthread_self(); }
  /// Since when it has been held, as another thread sees it; 0: it is free.
  Time since() const { return Time(since_.load(std::memory_order_relaxed)); }

  // While it is held, or by the last thread.
  Time longest() const { return longest_; }
  std::uint64_t holds() const { return holds_; }

 private:
  Time taken() {
    const Time now = monotonic_now();
    since_.store(now.count(), std::memory_order_relaxed);
    owner_.store(::pthread_self(), std::memory_order_relaxed);
    return now;
  }

  pthread_mutex_t mutex_;
  std::atomic<Time::rep> since_ = 0;
  std::atomic<pthread_t> owner_{};
  Time longest_{};
  std::uint64_t holds_ = 0;
};

}  // namespace pal::runtime
