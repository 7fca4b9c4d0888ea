#include "runtime/executives/real_time/schedule_threads.hpp"

#include <algorithm>

namespace pal::runtime {
namespace {

// SCHED_FIFO has 1 to 99. Below: what else is urgent on the machine. Above: time, the world, the watchdog.
constexpr int least_fifo = 10;
constexpr int most_priorities = 80;

/// The different priorities of the skill, from the least.
std::vector<int> priorities_of(const Wiring& wiring) {
  std::vector<int> priorities;
  for (const ThreadSpec& thread : wiring.threads) priorities.push_back(thread.priority);
  std::sort(priorities.begin(), priorities.end());
  priorities.erase(std::unique(priorities.begin(), priorities.end()), priorities.end());
  return priorities;
}

void pin_levels(const Wiring& wiring, Levels& levels, std::vector<std::string>& shortcomings) {
  const std::vector<int> cpus = permitted_cpus();
  if (wiring.processors.size() > cpus.size())
    shortcomings.push_back(std::to_string(wiring.processors.size()) + " processors share " +
                           std::to_string(cpus.size()) + (cpus.size() == 1 ? " CPU" : " CPUs"));
  // The last ones first: the first one serves interrupts.
  const auto cpu_of = [&cpus](int processor) {
    return cpus[cpus.size() - 1 - static_cast<std::size_t>(processor) % cpus.size()];
  };
  for (const Level& level : levels.all()) {
    const std::string problem = pin(level.os_thread, cpu_of(level.processor));
    if (problem.empty()) continue;
    shortcomings.push_back("a processor is not kept on one CPU (" + problem + ")");
    break;
  }
}

}  // namespace

std::optional<int> schedule_threads(const Wiring& wiring, Levels& levels,
                                    const std::vector<std::unique_ptr<OsThread>>& threads,
                                    std::vector<std::string>& shortcomings) {
  pin_levels(wiring, levels, shortcomings);
  std::vector<int> priorities = priorities_of(wiring);
  if (priorities.size() > most_priorities) {
    shortcomings.push_back("the skill has " + std::to_string(priorities.size()) +
                           " priorities; SCHED_FIFO tells the greatest " + std::to_string(most_priorities) +
                           " apart");
    priorities.erase(priorities.begin(), priorities.end() - most_priorities);
  }
  const auto rank = [&priorities](int priority) {
    const auto at = std::lower_bound(priorities.begin(), priorities.end(), priority);
    return least_fifo + static_cast<int>(at - priorities.begin());
  };
  const int top = least_fifo + most_priorities - 1;
  std::string problem = make_fifo(threads.front()->handle(), top + 1);
  for (const Level& level : levels.all())
    if (problem.empty()) problem = make_fifo(level.os_thread, rank(level.priority));
  if (problem.empty()) return top;
  for (const auto& thread : threads) make_ordinary(thread->handle());
  shortcomings.push_back("SCHED_FIFO is not permitted (" + problem +
                         "): the system may run other work, or a thread of less priority, first");
  return std::nullopt;
}

}  // namespace pal::runtime
