// Threads of the operating system, their priorities and CPUs; memory.
#pragma once

#include <pthread.h>

#include <functional>
#include <string>
#include <vector>

namespace pal::runtime {

/// A thread that is joined before it is destroyed. Its stack is allocated before it is used.
class OsThread {
 public:
  /// `name`: as the system shows it, up to 15 characters. `body` must not throw. Throws std::system_error
  /// when the system gives no more threads.
  OsThread(const std::string& name, std::function<void()> body);
  ~OsThread() { join(); }
  OsThread(const OsThread&) = delete;
  OsThread& operator=(const OsThread&) = delete;

  pthread_t handle() const { return thread_; }
  void join();

 private:
  static void* enter(void* self);

  std::function<void()> body_;
  pthread_t thread_{};
  bool joined_ = false;
};

/// Sets SCHED_FIFO with this priority. Empty: done; otherwise why not.
std::string make_fifo(pthread_t thread, int priority);
/// Sets the ordinary policy of the system.
void make_ordinary(pthread_t thread);
std::string pin(pthread_t thread, int cpu);
/// The CPUs that the process may use; never none.
std::vector<int> permitted_cpus();

/// Gives the calling thread SCHED_FIFO for as long as it lives.
class ScopedFifo {
 public:
  /// `priority` 0: it stays as it is.
  explicit ScopedFifo(int priority);
  ~ScopedFifo();
  ScopedFifo(const ScopedFifo&) = delete;
  ScopedFifo& operator=(const ScopedFifo&) = delete;

 private:
  bool changed_ = false;
  int policy_ = 0;
  int priority_ = 0;
};

/// Locks the present and future memory of the process, for as long as this object lives.
class LockedMemory {
 public:
  explicit LockedMemory(bool wanted);
  ~LockedMemory();
  LockedMemory(const LockedMemory&) = delete;
  LockedMemory& operator=(const LockedMemory&) = delete;

  /// Why memory is not locked although it was wanted; empty: it is, or it was not wanted.
  const std::string& problem() const { return problem_; }

 private:
  bool locked_ = false;
  std::string problem_;
};

}  // namespace pal::runtime
