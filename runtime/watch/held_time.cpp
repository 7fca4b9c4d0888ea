#include "runtime/watch/held_time.hpp"

#include <sys/resource.h>

#include <ctime>

#include <algorithm>

namespace pal::runtime {
namespace {

Time time_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
}

/// How often the calling thread has slept or waited so far.
long given_away() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_nvcsw;
}

/// The processor time of this computer that the calling thread has had so far.
Time processor_time() {
  return time_of(CLOCK_THREAD_CPUTIME_ID);
}

}  // namespace

// The processor time is read last and then first: it has the least of the other readings in it.
HeldTime::HeldTime()
    : given_away_(given_away()), begun_(time_of(CLOCK_MONOTONIC)), worked_(processor_time()) {}

void HeldTime::end() {
  worked_ = processor_time() - worked_;
  taken_ = time_of(CLOCK_MONOTONIC) - begun_;
  blocked_ = given_away() != given_away_;
}

Time HeldTime::by_the_wall(Time interrupted) const {
  return std::max(worked_, taken_ - interrupted);
}

Time cost_of_held_time() {
  constexpr int times = 100;
  Time least = Time::max();
  for (int i = 0; i < times; ++i) {
    HeldTime time;
    time.end();
    least = std::min(least, time.held());
  }
  return least;
}

}  // namespace pal::runtime
