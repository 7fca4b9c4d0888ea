#include "runtime/executives/real_time/kernel_lock.hpp"

#include <system_error>

namespace pal::runtime {

KernelLock::KernelLock() {
  pthread_mutexattr_t attributes;
  ::pthread_mutexattr_init(&attributes);
  int problem = ::pthread_mutexattr_setprotocol(&attributes, PTHREAD_PRIO_INHERIT);
  if (problem == 0) problem = ::pthread_mutex_init(&mutex_, &attributes);
  ::pthread_mutexattr_destroy(&attributes);
  if (problem != 0)
    throw std::system_error(problem, std::generic_category(), "a mutex with priority inheritance");
}

}  // namespace pal::runtime
