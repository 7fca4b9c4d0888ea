// The processor's time, which other programs do not change much.
#pragma once

#include <ctime>

namespace pal::bench {

/// Of this thread, or of all threads of this process; seconds.
inline double cpu_seconds(clockid_t clock = CLOCK_THREAD_CPUTIME_ID) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace pal::bench
