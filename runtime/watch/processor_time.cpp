#include "runtime/watch/processor_time.hpp"

#include <ctime>

#include <algorithm>

namespace pal::runtime {

Time processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
}

Time cost_of_processor_time() {
  constexpr int pairs = 100;
  Time least = Time::max();
  for (int i = 0; i < pairs; ++i) {
    const Time before = processor_time();
    least = std::min(least, processor_time() - before);
  }
  return least;
}

}  // namespace pal::runtime
