#include "server/urgency.hpp"

#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace pal::server {
namespace {

// The system's sched_attr, in its first form (man 2 sched_setattr); the C library does not have it.
struct SchedulingAttributes {
  std::uint32_t size = sizeof(SchedulingAttributes);
  std::uint32_t policy = SCHED_OTHER;
  std::uint64_t flags = 0;
  std::int32_t nice = 0;
  std::uint32_t priority = 0;
  std::uint64_t runtime = 0;  // ns; the turn of a thread that is not real time
  std::uint64_t deadline = 0, period = 0;
};

}  // namespace

void answer_soon() noexcept {
  SchedulingAttributes wanted;
  wanted.nice = ::getpriority(PRIO_PROCESS, 0);
  wanted.runtime = 100'000;  // the shortest
  ::syscall(SYS_sched_setattr, 0, &wanted, 0U);
}

void work_beside() noexcept {
  constexpr int less_urgent = 5;
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_BATCH, &none);
  // On Linux this is of the thread.
  ::setpriority(PRIO_PROCESS, 0, less_urgent);
}

}  // namespace pal::server
