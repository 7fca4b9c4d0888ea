// Stopping, pausing, stepping, breakpoints; which events of a run are kept.
#include <catch2/catch.hpp>
#include <future>
#include <map>
#include <set>
#include <thread>

#include "pal/runtime/run_control.hpp"
#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
using runtime::from;
using runtime::RunControl;
using runtime::Task;
using runtime::Thread;
using runtime::Time;

namespace {

// Has a statement of every kind: an activity, sets, reads, tests, sends that block, and a completion. Waits
// take and give up, for one message and for the first of two. A CONCURRENT has a block that is cancelled.
struct Everything {
  Everything() {
    const int p = skill.processor("P");
    const int q = skill.processor("Q", false);
    skill.devices = {"sensor"};
    skill.latency = {{100us, 100us}, {300us, 300us}};
    skill.test = {200us, 200us};
    const int request = skill.channel("A", "request x", "sensor");
    skill.channels.back().to_device = true;
    const int x = skill.channel("sensor", "x", "A");
    skill.channels.back().from_device = true;
    skill.channels.front().answer = x;
    const int y = skill.channel("A", "y", "B");
    const int never = skill.channel("B", "never", "A");
    const int c = skill.condition("c");
    for (const char* text : {"start", "act", "set", "read", "test", "ask", "take", "give up", "first of two",
                             "put", "get", "concurrent", "spin", "end"})
      at[text] = skill.statement(text, 1ms);
    const int a = skill.thread("A", p, 1, [=, this](Thread& t) -> Task {
      co_await t.take_start(at["start"]);
      co_await t.perform(at["act"], [] {});
      co_await t.set(at["set"], c, true);
      co_await t.read(at["read"], c);
      co_await t.test(at["test"], c);
      co_await t.send(at["ask"], request);
      co_await t.wait(at["take"], from(x));
      co_await t.wait_within(at["give up"], 2ms, from(never));
      co_await t.send(at["ask"], request);
      co_await t.wait(at["first of two"], from(never), from(x));
      co_await t.send(at["put"], y);
      co_await t.send(at["put"], y);
      co_await t.send(at["put"], y);
      co_await t.concurrent(at["concurrent"], 2, 3);
      co_await t.complete(at["end"], 0);
    });
    skill.thread("B", q, 2, [=, this](Thread& t) -> Task {
      for (int i = 0; i < 3; ++i) {
        co_await t.perform(at["act"], [] {});
        co_await t.wait(at["get"], from(y));
      }
    });
    skill.block("A.1", a, p, 3, true, [=, this](Thread& t) -> Task {
      co_await t.perform(at["act"], [] {});
      co_await t.perform(at["act"], [] {});
    });
    skill.block("A.2", a, p, 2, false, [=, this](Thread& t) -> Task {
      for (;;) co_await t.perform(at["spin"], [] {});
    });
    sensor.on_receive = [](runtime::DeviceHost& host, std::size_t, std::span<const double>) {
      host.mark_busy(true);
      host.at(host.now() + 3ms, [&host] {
        host.deliver(1, {});
        host.mark_busy(false);
      });
    };
  }
  WrittenSkill skill;
  ScriptedDevice sensor{"sensor", {{"request x", true, {}}, {"x", false, {}}}};
  std::map<std::string, int> at;
};

}  // namespace

TEST_CASE("a stop at every instant of a run, during every statement of every kind") {
  Everything whole;
  const auto complete = run(whole.skill, {&whole.sensor});
  REQUIRE(complete.code == 0);
  std::set<Time> instants{Time(0)};
  std::set<int> seen;
  for (const trace::Event& event : complete.trace.events) {
    for (const int beside : {-1, 0, 1}) instants.insert(std::max(Time(0), Time(event.time_ns + beside)));
    if (event.statement >= 0) seen.insert(event.statement);
  }
  CHECK(seen.size() == whole.at.size());  // every kind takes part
  std::size_t stopped = 0;
  for (const Time instant : instants) {
    if (instant > complete.duration) continue;
    CAPTURE(instant.count());
    Everything each;
    RunControl control;
    control.stop_at(instant);
    const auto outcome = run(each.skill, {&each.sensor}, {.control = &control});
    CHECK(outcome.fault);
    CHECK(outcome.code == 9);
    CHECK(outcome.reason == "stopped on request");
    CHECK(outcome.duration == instant);
    CHECK(each.sensor.closed == 1);
    // What happened before is what happens without a stop.
    trace::Events before = outcome.trace.events;
    std::erase_if(before, [&](const trace::Event& event) { return Time(event.time_ns) >= instant; });
    CHECK(std::equal(before.begin(), before.end(), complete.trace.events.begin()));
    ++stopped;
  }
  CHECK(stopped > 60);
}

TEST_CASE(
    "a run is paused, stepped, held at a breakpoint and goes on, from another thread, its trace is the "
    "same") {
  Everything plain, held;
  const auto expected = run(plain.skill, {&plain.sensor});
  RunControl control;
  control.pause();
  auto outcome =
      std::async(std::launch::async, [&] { return run(held.skill, {&held.sensor}, {.control = &control}); });
  using namespace std::chrono_literals;
  auto halt = control.wait_for_halt(10s);
  REQUIRE(halt);
  CHECK(halt->reason == "paused");
  CHECK(halt->time == 0ms);
  CHECK(halt->next.find("A at act") != std::string::npos);
  CHECK(halt->threads.size() == 2);

  control.step();
  halt = control.wait_for_halt(10s);
  REQUIRE(halt);
  CHECK(halt->reason == "stepped");
  CHECK(halt->time == 1ms);

  control.break_at("written.pal", held.skill.statements[static_cast<std::size_t>(held.at["take"])].line);
  control.resume();
  halt = control.wait_for_halt(10s);
  REQUIRE(halt);
  CHECK(halt->reason == "breakpoint at written.pal:7");
  CHECK(halt->next.find("A at take") != std::string::npos);
  CHECK(!control.wait_for_halt(0ms)->next.empty());  // it stays

  control.clear_breakpoints();
  control.resume();
  const auto result = outcome.get();
  CHECK(result.code == 0);
  CHECK(result.trace.events == expected.trace.events);
}

TEST_CASE("a run that is held is stopped") {
  Everything each;
  RunControl control;
  control.pause();
  auto outcome =
      std::async(std::launch::async, [&] { return run(each.skill, {&each.sensor}, {.control = &control}); });
  REQUIRE(control.wait_for_halt(std::chrono::seconds(10)));
  control.stop();
  CHECK(outcome.get().reason == "stopped on request");
  CHECK(each.sensor.closed == 1);
}

TEST_CASE("a trace has all events, the last ones or none, and always the faults") {
  const auto traced = [](runtime::TraceMode mode) {
    Everything each;
    return run(each.skill, {&each.sensor}, {.trace = mode, .trace_capacity = 7}).trace.events;
  };
  const auto all = traced(runtime::TraceMode::all);
  const auto last = traced(runtime::TraceMode::last);
  REQUIRE(all.size() > 7);
  REQUIRE(last.size() == 7);
  CHECK(std::equal(last.begin(), last.end(), all.end() - 7));
  CHECK(traced(runtime::TraceMode::none).empty());

  Everything stopped;
  RunControl control;
  control.stop();
  const auto outcome =
      run(stopped.skill, {&stopped.sensor}, {.trace = runtime::TraceMode::none, .control = &control});
  CHECK(outcome.trace.faults == std::vector<std::string>{"stopped on request"});
}
