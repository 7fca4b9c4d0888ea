// bench_runtime [ROUNDS]; bench_runtime none|last|all|two|eight, for a profiler: 20,000 round trips of a
// skill with such a trace, or as many requirements. What a Send, Receive, Reply round trip costs, beside
// other ways to pass a message and its answer. All are measured in turns in one run, in processor time, or by
// the wall where it says so. Figures are medians (docs/internals/benchmarks.md).
#include <time.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/benchmark/runtime/rows.hpp"

namespace {

using namespace pal;

constexpr std::size_t round_trips = 50'000;

/// Of the process, in nanoseconds: what else runs on the machine counts little.
double processor_time() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

double time_on_the_wall() {
  const std::chrono::duration<double, std::nano> now = std::chrono::steady_clock::now().time_since_epoch();
  return now.count();
}

struct Row {
  std::string name;
  std::size_t count;
  std::function<void(std::size_t)> make;
  double (*clock)() = processor_time;
  std::vector<double> nanoseconds = {};

  double median() const {
    std::vector<double> sorted = nanoseconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

Row watched(std::size_t requirements) {
  return {"a skill of 3 threads, no trace, " + std::to_string(requirements) + " requirements", round_trips,
          [requirements](std::size_t count) {
            benchmark::skill_round_trips(count, 3, runtime::TraceMode::none, requirements);
          }};
}

Row starts(std::size_t threads, bool blocks) {
  return {
      "a thread of " + std::to_string(threads) + (blocks ? " blocks" : "") + ", from its start to its end",
      20'000, [threads, blocks](std::size_t count) { benchmark::skill_starts(count, threads, blocks); }};
}

Row skill(std::size_t threads, runtime::TraceMode mode, const std::string& trace) {
  return {"a skill of " + std::to_string(threads) + " threads, " + trace, round_trips,
          [threads, mode](std::size_t count) { benchmark::skill_round_trips(count, threads, mode); }};
}

/// What a profiler is to see.
struct Profiled {
  const char* name;
  runtime::TraceMode mode;
  std::size_t requirements;
};

std::optional<Profiled> profiled_named(const char* name) {
  using runtime::TraceMode;
  static constexpr Profiled all[] = {{"none", TraceMode::none, 0},
                                     {"last", TraceMode::last, 0},
                                     {"all", TraceMode::all, 0},
                                     {"two", TraceMode::none, 2},
                                     {"eight", TraceMode::none, 8}};
  for (const Profiled& each : all)
    if (std::strcmp(name, each.name) == 0) return each;
  return std::nullopt;
}

void measure(std::vector<Row>& rows, int rounds) {
  for (int round = -1; round < rounds; ++round) {  // the first one warms up
    for (Row& row : rows) {
      const double begun = row.clock();
      row.make(row.count);
      if (round >= 0) row.nanoseconds.push_back((row.clock() - begun) / static_cast<double>(row.count));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  int rounds = 15;
  const std::optional<Profiled> profiled = argc == 2 ? profiled_named(argv[1]) : std::nullopt;
  if (argc == 2 && !profiled) {
    const char* end = argv[1] + std::strlen(argv[1]);
    const auto [at, problem] = std::from_chars(argv[1], end, rounds);
    if (problem != std::errc() || at != end || rounds < 1 || rounds > 10'000) argc = 3;
  }
  if (argc > 2) {
    std::fprintf(stderr, "usage: bench_runtime [ROUNDS], from 1 to 10000; or none, last, all, two, eight\n");
    return 2;
  }
  try {
    using runtime::TraceMode;
    if (profiled) {
      benchmark::skill_round_trips(20'000, 27, profiled->mode, profiled->requirements);
      return 0;
    }
    std::vector<Row> rows;
    const bool fibers = benchmark::fiber_round_trips(1);
    if (fibers)
      rows.push_back({"two fibers of Boost.Fiber, two channels", round_trips,
                      [](std::size_t count) { benchmark::fiber_round_trips(count); }});
    for (const std::size_t threads : {3U, 27U, 100U})
      rows.push_back(skill(threads, TraceMode::none, "no trace"));
    for (const std::size_t threads : {3U, 27U, 100U})
      rows.push_back(skill(threads, TraceMode::last, "trace of the last 4096"));
    for (const std::size_t threads : {3U, 27U, 100U})
      rows.push_back(skill(threads, TraceMode::all, "whole trace"));
    for (const std::size_t requirements : {2U, 8U}) rows.push_back(watched(requirements));
    for (const bool blocks : {false, true})
      for (const std::size_t threads : {100U, 1000U}) rows.push_back(starts(threads, blocks));
    rows.push_back({"two threads, mutex and condition variable (wall)", round_trips / 25,
                    benchmark::thread_round_trips, time_on_the_wall});
    rows.push_back({"two coroutines, bare transfers", 20 * round_trips, benchmark::bare_transfers});
    measure(rows, rounds);
    std::printf("%-50s %10s %10s\n", "one round trip", "ns", fibers ? "by fibers" : "");
    for (const Row& row : rows) {
      std::printf("%-50s %10.1f", row.name.c_str(), row.median());
      if (fibers) std::printf(" %10.2f", row.median() / rows.front().median());
      std::printf("\n");
    }
    if (!fibers) std::printf("built without Boost.Fiber: install libboost-fiber-dev and configure again\n");
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "bench_runtime: %s\n", problem.what());
    return 1;
  }
}
