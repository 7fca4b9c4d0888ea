#include "runtime/executives/real_time/clock.hpp"

#include <cerrno>

namespace pal::runtime {

bool Sleeper::sleep_until(Time when) {
  // A semaphore rather than clock_nanosleep, which no thread could wake: an earlier event may come in.
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(when);
  const timespec until{static_cast<time_t>(seconds.count()), static_cast<long>((when - seconds).count())};
  int result = 0;
  do {
    result = ::sem_clockwait(&semaphore_, CLOCK_MONOTONIC, &until);
  } while (result != 0 && errno == EINTR);
  return result == 0;
}

}  // namespace pal::runtime
