#include "study/cores.hpp"

#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <new>
#include <system_error>
#include <thread>

namespace pal::study {
namespace {

/// In memory that all processes share.
struct Counters {
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
};
static_assert(std::atomic<std::size_t>::is_always_lock_free);

class Shared {
 public:
  Shared()
      : memory_(
            ::mmap(nullptr, sizeof(Counters), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (memory_ == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "shared memory");
    counters_ = new (memory_) Counters;
  }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;
  ~Shared() { ::munmap(memory_, sizeof(Counters)); }
  Counters& operator*() { return *counters_; }

 private:
  void* memory_;
  Counters* counters_ = nullptr;
};

constexpr int out_of_memory = 3, other_trouble = 4;

[[noreturn]] void work_on(const CoresWork& work, Counters& counters) {
  int status = 0;
  try {
    while (!work.stop || !work.stop()) {
      const std::size_t piece = counters.next++;
      if (piece >= work.pieces) break;
      work.work(piece);
      if (!work.stop || !work.stop()) ++counters.done;
    }
  } catch (const std::bad_alloc&) {
    status = out_of_memory;
  } catch (...) {
    status = other_trouble;
  }
  ::_exit(status);  // what the parent has buffered is the parent's to write
}

std::string death_of(int status) {
  if (WIFSIGNALED(status))
    return "by signal " + std::to_string(WTERMSIG(status)) + " (" + ::strsignal(WTERMSIG(status)) + ")";
  if (WEXITSTATUS(status) == out_of_memory) return "for lack of memory";
  return "with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

Deaths run_on_cores(const CoresWork& work) {
  using namespace std::chrono_literals;
  constexpr auto look = 20ms;
  Shared shared;
  std::vector<pid_t> processes;
  const std::size_t wanted = std::min<std::size_t>(std::max(1U, work.processes), work.pieces);
  // No process runs the parent's handler: until it has its own way to end, SIGTERM waits.
  sigset_t termination, before;
  ::sigemptyset(&termination);
  ::sigaddset(&termination, SIGTERM);
  ::sigprocmask(SIG_BLOCK, &termination, &before);
  for (std::size_t i = 0; i < wanted; ++i) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::signal(SIGTERM, SIG_DFL);  // whatever the parent does with its own
      ::sigprocmask(SIG_SETMASK, &before, nullptr);
      work_on(work, *shared);
    }
    if (child > 0) processes.push_back(child);
  }
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
  if (processes.empty() && wanted > 0) throw std::system_error(errno, std::generic_category(), "a process");
  Deaths deaths;
  bool told = false;
  while (!processes.empty()) {
    std::erase_if(processes, [&deaths, &told](pid_t child) {
      int status = 0;
      const pid_t ended = ::waitpid(child, &status, WNOHANG);
      if (ended == 0 || (ended < 0 && errno == EINTR)) return false;
      const bool well = ended < 0 || (WIFEXITED(status) && WEXITSTATUS(status) == 0);
      if (!well && !told) deaths.push_back(death_of(status));
      return true;
    });
    if (work.progress) work.progress((*shared).done);
    if (!told && work.stop && work.stop()) {
      told = true;
      for (const pid_t child : processes) ::kill(child, SIGTERM);
    }
    if (!processes.empty()) std::this_thread::sleep_for(look);
  }
  return deaths;
}

}  // namespace pal::study
