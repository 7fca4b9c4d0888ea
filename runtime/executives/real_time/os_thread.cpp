#include "runtime/executives/real_time/os_thread.hpp"

#include <sched.h>
#include <sys/mman.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

namespace pal::runtime {
namespace {

constexpr std::size_t stack_size = 1U << 20U;
constexpr std::size_t prefaulted = 1U << 17U;
constexpr std::size_t page = 4096;
constexpr std::size_t longest_name = 15;

[[gnu::noinline]] void touch_stack() {
  std::array<char, prefaulted> bytes;
  volatile char* memory = bytes.data();
  for (std::size_t i = 0; i < prefaulted; i += page) memory[i] = 0;
}

/// The allocator makes an arena for a thread that allocates for the first time, and that takes long where
/// memory is locked. An observer may allocate while the skill runs.
void touch_arena() {
  void* volatile memory = std::malloc(1);
  std::free(memory);
}

}  // namespace

OsThread::OsThread(const std::string& name, std::function<void()> body) : body_(std::move(body)) {
  pthread_attr_t attributes;
  ::pthread_attr_init(&attributes);
  ::pthread_attr_setstacksize(&attributes, stack_size);
  const int problem = ::pthread_create(&thread_, &attributes, enter, this);
  ::pthread_attr_destroy(&attributes);
  if (problem != 0) throw std::system_error(problem, std::generic_category(), "a thread for the run");
  ::pthread_setname_np(thread_, name.substr(0, longest_name).c_str());
}

void* OsThread::enter(void* self) {
  touch_stack();
  touch_arena();
  static_cast<OsThread*>(self)->body_();
  return nullptr;
}

void OsThread::join() {
  if (!std::exchange(joined_, true)) ::pthread_join(thread_, nullptr);
}

std::string make_fifo(pthread_t thread, int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  const int problem = ::pthread_setschedparam(thread, SCHED_FIFO, &parameters);
  return problem == 0 ? std::string() : std::generic_category().message(problem);
}

void make_ordinary(pthread_t thread) {
  const sched_param parameters{};
  ::pthread_setschedparam(thread, SCHED_OTHER, &parameters);
}

std::string pin(pthread_t thread, int cpu) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<std::size_t>(cpu), &set);
  const int problem = ::pthread_setaffinity_np(thread, sizeof set, &set);
  return problem == 0 ? std::string() : std::generic_category().message(problem);
}

std::vector<int> permitted_cpus() {
  cpu_set_t set;
  CPU_ZERO(&set);
  std::vector<int> result;
  if (::sched_getaffinity(0, sizeof set, &set) == 0) {
    for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu)
      if (CPU_ISSET(static_cast<std::size_t>(cpu), &set)) result.push_back(cpu);
  }
  if (result.empty()) result.push_back(0);
  return result;
}

ScopedFifo::ScopedFifo(int priority) {
  if (priority == 0) return;
  sched_param before{};
  if (::pthread_getschedparam(::pthread_self(), &policy_, &before) != 0) return;
  priority_ = before.sched_priority;
  changed_ = make_fifo(::pthread_self(), priority).empty();
}

ScopedFifo::~ScopedFifo() {
  if (!changed_) return;
  sched_param before{};
  before.sched_priority = priority_;
  ::pthread_setschedparam(::pthread_self(), policy_, &before);
}

LockedMemory::LockedMemory(bool wanted) {
  if (!wanted) return;
  locked_ = ::mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
  if (!locked_) problem_ = std::generic_category().message(errno);
}

LockedMemory::~LockedMemory() {
  if (locked_) ::munlockall();
}

}  // namespace pal::runtime
