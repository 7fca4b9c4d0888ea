#include "programs/pal/session/memory.hpp"

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>

namespace pal::program {
namespace {

std::optional<std::size_t> number_in(const std::string& path) {
  std::ifstream file(path);
  std::size_t number = 0;
  if (file >> number) return number;
  return std::nullopt;  // "max", or there is no such file
}

std::optional<std::size_t> kilobytes_of(const std::string& path, const std::string& name) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.rfind(name, 0) == 0) return std::stoul(line.substr(name.size()));
  }
  return std::nullopt;
}

/// The least limit of the program's control group and of those around it.
std::size_t limit_of_groups() {
  std::size_t least = SIZE_MAX;
  const auto limit = [&least](const std::string& path) {
    if (const auto found = number_in(path); found && *found > 0) least = std::min(least, *found);
  };
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const auto kind = line.find(':');
    const auto name = line.find(':', kind + 1);
    if (kind == std::string::npos || name == std::string::npos) continue;
    const bool unified = name == kind + 1;
    if (!unified && line.substr(kind + 1, name - kind - 1) != "memory") continue;
    std::string group = line.substr(name + 1);
    for (;;) {
      if (group == "/") group.clear();
      limit(unified ? "/sys/fs/cgroup" + group + "/memory.max"
                    : "/sys/fs/cgroup/memory" + group + "/memory.limit_in_bytes");
      if (group.empty()) break;
      group.erase(group.rfind('/'));
    }
  }
  return least;
}

/// In bytes (proc(5)).
struct Taken {
  std::size_t addresses = 0;
  std::size_t resident = 0;
};

Taken taken() {
  std::ifstream file("/proc/self/statm");
  Taken pages;
  file >> pages.addresses >> pages.resident;
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return {pages.addresses * page, pages.resident * page};
}

/// Whether more than `bytes` are resident, or nearly all of the address space is taken that the program may
/// have.
bool is_over(std::size_t bytes) {
  const Taken now = taken();
  rlimit limit{};
  const bool limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return now.resident > bytes || (limited && now.addresses > limit.rlim_cur / 8 * 7);
}

}  // namespace

std::size_t memory_there_is() {
  std::size_t least = limit_of_groups();
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    least = std::min<std::size_t>(least, limit.rlim_cur);
  if (const auto free = kilobytes_of("/proc/meminfo", "MemAvailable:")) least = std::min(least, *free * 1024);
  return least;
}

bool takes_more(std::size_t bytes) {
  using Clock = std::chrono::steady_clock;
  constexpr std::int64_t every = 5'000'000;
  static std::atomic<std::int64_t> looked = 0;
  static std::atomic<bool> more = false;
  const std::int64_t now = Clock::now().time_since_epoch().count();
  std::int64_t last = looked;
  if (now - last < every || !looked.compare_exchange_strong(last, now)) return more;
  if (is_over(bytes)) give_back_memory();
  more = is_over(bytes);
  return more;
}

void give_back_memory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

void give_back_memory_beyond(std::size_t bytes) {
#ifdef __GLIBC__
  const std::size_t resident = taken().resident;
  if (resident <= bytes) return;
  const auto heap = ::mallinfo2();  // which other threads wait for
  if (resident > heap.uordblks + heap.hblkhd + bytes) give_back_memory();
#else
  (void)bytes;
#endif
}

std::size_t peak_memory() {
  const std::size_t kilobytes = kilobytes_of("/proc/self/status", "VmHWM:").value_or(0);
  std::ofstream("/proc/self/clear_refs") << "5\n";  // resets the peak (proc(5))
  return kilobytes * 1024;
}

}  // namespace pal::program
