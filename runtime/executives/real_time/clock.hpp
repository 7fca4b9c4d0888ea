// Clocks and sleeping, by the system's own calls.
#pragma once

#include <semaphore.h>
#include <time.h>

#include "pal/runtime/device.hpp"

namespace pal::runtime {

/// The clock of all instants of a run in real time.
inline Time monotonic_now() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::chrono::seconds(now.tv_sec) + Time(now.tv_nsec);
}

/// Where one thread sleeps until another one wakes it. A wake before the sleep is not lost.
class Sleeper {
 public:
  Sleeper() { ::sem_init(&semaphore_, 0, 0); }
  ~Sleeper() { ::sem_destroy(&semaphore_); }
  Sleeper(const Sleeper&) = delete;
  Sleeper& operator=(const Sleeper&) = delete;

  void wake() { ::sem_post(&semaphore_); }
  void sleep() {
    while (::sem_wait(&semaphore_) != 0) continue;  // a signal came
  }
  /// Sleeps until `when` of the monotonic clock at most; errors do not add up. False: it was not woken.
  bool sleep_until(Time when);

 private:
  sem_t semaphore_;
};

}  // namespace pal::runtime
