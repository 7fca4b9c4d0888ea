// bench_real_time [ROUNDS | loop CYCLES]: real time (docs/internals/benchmarks.md). Without `loop`: Send,
// Receive, Reply between two processors. It is measured beside two threads with a mutex and a condition
// variable, in turns in one run, by the wall. With `loop`: a loop of 28 ms, and how late it was.
#include <algorithm>
#include <charconv>
#include <condition_variable>
#include <cstdio>
#include <cstring>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "pal/runtime/dispatcher.hpp"
#include "pal/runtime/still_world.hpp"
#include "runtime/executives/real_time/clock.hpp"
#include "runtime/executives/real_time/os_thread.hpp"
#include "tests/run/support/bench.hpp"

namespace {

using namespace std::chrono_literals;
using namespace pal;
using runtime::from;
using runtime::Task;
using runtime::Thread;
using runtime::Time;

constexpr int round_trips = 2000;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

runtime::RunOptions real_time(bool fifo) {
  runtime::RunOptions options;
  options.real_time.emplace().fifo = fifo;
  options.trace = runtime::TraceMode::last;
  options.trace_capacity = 4096;
  return options;
}

/// Nanoseconds of one round trip; what the run reports of itself goes into `report`.
double by_skill(bool fifo, Time look_out, runtime::RealTimeReport& report) {
  test::WrittenSkill skill;
  const int p = skill.processor("P");
  const int q = skill.processor("Q");
  const int request = skill.channel("CLIENT", "request x", "SERVER");
  const int answer = skill.channel("SERVER", "x", "CLIENT");
  skill.channels[static_cast<std::size_t>(request)].answer = answer;
  const int act = skill.statement("clock", 1s);
  const int send = skill.statement("send", 1s);
  const int receive = skill.statement("receive", 1s);
  Time begun{}, ended{};
  skill.thread("CLIENT", p, 1, [&](Thread& t) -> Task {
    co_await t.perform(act, [&] { begun = runtime::monotonic_now(); });
    for (int i = 0; i < round_trips; ++i) {
      co_await t.send(send, request);
      co_await t.wait(receive, from(answer));
    }
    co_await t.perform(act, [&] { ended = runtime::monotonic_now(); });
    co_await t.complete(send, 0);
  });
  skill.thread("SERVER", q, 1, [&](Thread& t) -> Task {
    for (;;) {
      co_await t.wait(receive, from(request));
      co_await t.send(send, answer);
    }
  });
  runtime::RunOptions options = real_time(fifo);
  options.real_time->look_out = look_out;
  const runtime::Outcome outcome = test::run(skill, {}, options);
  if (outcome.code != 0) throw std::runtime_error(outcome.reason);
  report = *outcome.real_time;
  return static_cast<double>((ended - begun).count()) / round_trips;
}

void make_fifo_and_pin(runtime::OsThread& one, runtime::OsThread& other) {
  const std::vector<int> cpus = runtime::permitted_cpus();
  runtime::pin(one.handle(), cpus.back());
  runtime::pin(other.handle(), cpus[cpus.size() > 1 ? cpus.size() - 2 : 0]);
  runtime::make_fifo(one.handle(), 10);
  runtime::make_fifo(other.handle(), 10);
}

double by_condition_variable(bool fifo) {
  std::mutex mutex;
  std::condition_variable changed;
  bool asked = false, go = false;
  Time begun{}, ended{};
  runtime::OsThread server("server", [&] {
    std::unique_lock lock(mutex);
    for (int i = 0; i < round_trips; ++i) {
      changed.wait(lock, [&] { return asked; });
      asked = false;
      changed.notify_one();
    }
  });
  std::condition_variable start;
  runtime::OsThread client("client", [&] {
    std::unique_lock lock(mutex);
    start.wait(lock, [&] { return go; });
    begun = runtime::monotonic_now();
    for (int i = 0; i < round_trips; ++i) {
      asked = true;
      changed.notify_one();
      changed.wait(lock, [&] { return !asked; });
    }
    ended = runtime::monotonic_now();
  });
  if (fifo) make_fifo_and_pin(client, server);
  {
    const std::lock_guard lock(mutex);
    go = true;
  }
  start.notify_one();
  client.join();
  server.join();
  return static_cast<double>((ended - begun).count()) / round_trips;
}

void say(const runtime::RealTimeReport& report) {
  std::printf("the kernel was held %llu times, %.1f us at most\n",
              static_cast<unsigned long long>(report.holds),
              static_cast<double>(report.longest_hold.count()) * 1e-3);
  for (const std::string& lacking : report.shortcomings) std::printf("%s\n", lacking.c_str());
}

void compare(int rounds) {
  constexpr Time look_out = runtime::RealTime().look_out;
  constexpr std::size_t count = 6;
  std::vector<double> rows[count];
  runtime::RealTimeReport report;
  for (int round = -1; round < rounds; ++round) {  // the first one warms up
    const double values[] = {by_condition_variable(true),          by_skill(true, look_out, report),
                             by_skill(true, Time::zero(), report), by_condition_variable(false),
                             by_skill(false, look_out, report),    by_skill(false, Time::zero(), report)};
    for (std::size_t i = 0; i < count && round >= 0; ++i) rows[i].push_back(values[i]);
    if (round + 1 == rounds) by_skill(true, look_out, report);
  }
  const char* names[] = {"mutex and condition variable, SCHED_FIFO, pinned",
                         "a skill, SCHED_FIFO, pinned",
                         "a skill that sleeps at once (look_out 0), the same",
                         "mutex and condition variable, ordinary threads",
                         "a skill, ordinary threads",
                         "a skill that sleeps at once, the same"};
  std::printf("%-52s %9s %6s\n", "one round trip between two processors", "us", "ratio");
  for (std::size_t i = 0; i < count; ++i)
    std::printf("%-52s %9.2f %6.2f\n", names[i], median(rows[i]) * 1e-3,
                median(rows[i]) / median(rows[i < 3 ? 0 : 3]));
  say(report);
}

void print_distribution(const char* what, std::vector<Time> times) {
  std::sort(times.begin(), times.end());
  std::printf("%-34s", what);
  for (const double part : {0.0, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const auto at = static_cast<std::size_t>(part * static_cast<double>(times.size() - 1));
    std::printf(" %9.3f", static_cast<double>(times[at].count()) * 1e-6);
  }
  std::printf("\n");
}

constexpr Time period = 28ms, answer_within = 20ms;

/// How late the cycles of a loop were.
struct Lateness {
  std::vector<Time> ticks;    // tick later than due
  std::vector<Time> answers;  // answered after the tick was due
  std::size_t missed = 0;
};

/// A device ticks; a thread asks another one, on another CPU, and answers.
void loop_by_skill(std::size_t cycles, Lateness& lateness, runtime::RealTimeReport& report) {
  test::WrittenSkill skill;
  const int p = skill.processor("P");
  const int q = skill.processor("Q");
  skill.devices = {"port"};
  const int tick = skill.channel("port", "tick", "CONTROL");
  skill.channels.back().from_device = true;
  const int correction = skill.channel("CONTROL", "correction", "port");
  skill.channels.back().to_device = true;
  const int request = skill.channel("CONTROL", "request x", "METHOD");
  const int motion = skill.channel("METHOD", "x", "CONTROL");
  skill.channels[static_cast<std::size_t>(request)].answer = motion;
  const int send = skill.statement("send", 1s);
  const int receive = skill.statement("receive", 1s);
  test::ScriptedDevice port("port", {{"tick", false, {}}, {"correction", true, {}}});
  Time due{};
  struct Ticks {
    runtime::DeviceHost* host;
    std::function<void()> next;
  } ticks{};
  port.on_open = [&](runtime::DeviceHost& host) {
    ticks.host = &host;
    due = host.now() + period;
    ticks.next = [&] {
      lateness.ticks.push_back(ticks.host->now() - due);
      if (!ticks.host->deliver(0, {})) ++lateness.missed;
    };
    host.at(due, [&ticks] { ticks.next(); });
  };
  port.on_receive = [&](runtime::DeviceHost& host, std::size_t, std::span<const double>) {
    lateness.answers.push_back(host.now() - due);
    if (lateness.answers.back() > answer_within) ++lateness.missed;
    due += period;
    host.at(std::max(due, host.now()), [&ticks] { ticks.next(); });
  };
  skill.thread("CONTROL", p, 1, [&](Thread& t) -> Task {
    for (std::size_t i = 0; i < cycles; ++i) {
      co_await t.wait(receive, from(tick));
      co_await t.send(send, request);
      co_await t.wait(receive, from(motion));
      co_await t.send(send, correction);
    }
    co_await t.complete(send, 0);
  });
  skill.thread("METHOD", q, 1, [&](Thread& t) -> Task {
    for (;;) {
      co_await t.wait(receive, from(request));
      co_await t.send(send, motion);
    }
  });
  auto options = real_time(true);
  options.horizon = 2 * cycles * period;
  const runtime::Outcome outcome = test::run(skill, {&port}, options);
  if (outcome.code != 0) throw std::runtime_error(outcome.reason);
  report = *outcome.real_time;
}

/// The same without a skill: a thread sleeps until each tick, and asks another one by a condition variable.
void loop_without_skill(std::size_t cycles, Lateness& lateness) {
  std::mutex mutex;
  std::condition_variable changed;
  bool asked = false;
  runtime::OsThread method("method", [&] {
    std::unique_lock lock(mutex);
    for (std::size_t i = 0; i < cycles; ++i) {
      changed.wait(lock, [&] { return asked; });
      asked = false;
      changed.notify_one();
    }
  });
  runtime::OsThread control("control", [&] {
    runtime::Sleeper sleeper;
    Time due = runtime::monotonic_now() + period;
    for (std::size_t i = 0; i < cycles; ++i) {
      sleeper.sleep_until(due);
      lateness.ticks.push_back(runtime::monotonic_now() - due);
      std::unique_lock lock(mutex);
      asked = true;
      changed.notify_one();
      changed.wait(lock, [&] { return !asked; });
      lateness.answers.push_back(runtime::monotonic_now() - due);
      if (lateness.answers.back() > answer_within) ++lateness.missed;
      due += period;
    }
  });
  make_fifo_and_pin(control, method);
  control.join();
  method.join();
}

void print_lateness(const char* what, const Lateness& lateness) {
  std::printf("%s: %zu cycles of 28 ms, %zu missed\n%-34s %9s %9s %9s %9s %9s %9s\n", what,
              lateness.ticks.size(), lateness.missed, "ms", "least", "median", "90 %", "99 %", "99.9 %",
              "greatest");
  print_distribution("tick later than due", lateness.ticks);
  print_distribution("answered after it was due", lateness.answers);
}

/// Both loops in turns of at most 1000 cycles, so that what disturbs the machine meets both.
void loop(std::size_t cycles) {
  Lateness with, without;
  for (Lateness* each : {&with, &without}) {
    each->ticks.reserve(cycles);
    each->answers.reserve(cycles);
  }
  runtime::RealTimeReport report;
  for (std::size_t left = cycles; left > 0;) {
    const std::size_t now = std::min<std::size_t>(left, 1000);
    loop_by_skill(now, with, report);
    loop_without_skill(now, without);
    left -= now;
  }
  print_lateness("a skill", with);
  print_lateness("two threads with a mutex and a condition variable", without);
  say(report);
}

int number(const char* text) {
  int value = 0;
  const char* end = text + std::strlen(text);
  const auto [at, problem] = std::from_chars(text, end, value);
  return problem == std::errc() && at == end && value > 0 && value <= 1'000'000 ? value : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const bool loops = argc == 3 && std::strcmp(argv[1], "loop") == 0;
  const int count = loops ? number(argv[2]) : argc == 2 ? number(argv[1]) : argc == 1 ? 15 : 0;
  if (count == 0) {
    std::fprintf(stderr, "usage: bench_real_time [ROUNDS | loop CYCLES], from 1 to 1000000\n");
    return 2;
  }
  try {
    loops ? loop(static_cast<std::size_t>(count)) : compare(count);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "bench_real_time: %s\n", problem.what());
    return 1;
  }
}
