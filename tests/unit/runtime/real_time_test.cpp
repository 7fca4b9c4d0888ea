// Runs in real time: the order of messages, preemption, faults. No clock is asserted.
#include <pthread.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <functional>
#include <semaphore>
#include <thread>
#include <utility>

#include "pal/runtime/measurement.hpp"
#include "pal/runtime/run_control.hpp"
#include "runtime/executives/real_time/look_out.hpp"
#include "tests/run/support/allocation_count.hpp"
#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
using runtime::from;
using runtime::RunOptions;
using runtime::Task;
using runtime::Thread;

namespace {

RunOptions real_time() {
  RunOptions options;
  options.real_time.emplace();
  options.horizon = 8s;
  return options;
}

// CLIENT asks SERVER `rounds` times; each has a processor of its own, unless `together`. WITNESS, which is
// more urgent, is told of every round.
struct TalkInRealTime {
  explicit TalkInRealTime(int rounds, bool together = false) {
    const int p = skill.processor("P");
    const int q = together ? p : skill.processor("Q");
    const int request = skill.channel("CLIENT", "request x", "SERVER");
    const int answer = skill.channel("SERVER", "x", "CLIENT");
    const int note = skill.channel("SERVER", "note", "WITNESS");
    skill.channels[static_cast<std::size_t>(request)].answer = answer;
    const int act = skill.statement("act", 1ms);
    const int ask = skill.statement("ask", 1ms);
    const int take = skill.statement("take", 1ms);
    const int accept = skill.statement("accept", 1ms);
    const int tell = skill.statement("tell", 1ms);
    const int reply = skill.statement("reply", 1ms);
    const int hear = skill.statement("hear", 1ms);
    const int end = skill.statement("end", 1ms);
    skill.thread("CLIENT", p, 1, [=, this](Thread& t) -> Task {
      co_await t.perform(act, [this] {
        if (first) first();
      });
      for (int i = 0; i < rounds; ++i) {
        co_await t.send(ask, request);
        co_await t.wait_within(take, 5s, from(answer));
      }
      co_await t.perform(act, [this] {
        if (last) last();
      });
      co_await t.complete(end, 0);
    });
    skill.thread("SERVER", q, 2, [=](Thread& t) -> Task {
      for (;;) {
        co_await t.wait(accept, from(request));
        co_await t.send(tell, note);
        co_await t.send(reply, answer);
      }
    });
    skill.thread("WITNESS", q, 3, [=](Thread& t) -> Task {
      for (;;) co_await t.wait(hear, from(note));
    });
  }
  WrittenSkill skill;
  std::function<void()> first, last;
};

// What was put and taken, by which thread, in which order; without instants.
std::vector<std::array<int, 4>> messages(const runtime::Outcome& outcome) {
  std::vector<std::array<int, 4>> result;
  for (const trace::Event& event : outcome.trace.events)
    if (event.kind == trace::Kind::put || event.kind == trace::Kind::take)
      result.push_back({static_cast<int>(event.kind), event.actor, event.subject, event.value});
  return result;
}

std::string kinds(const runtime::Outcome& outcome) {
  std::string text;
  for (const trace::Event& event : outcome.trace.events) {
    if (event.actor < 0 || event.statement < 0) continue;
    if (event.kind == trace::Kind::broken) continue;  // how long it takes is the machine's
    text += outcome.trace.actors[static_cast<std::size_t>(event.actor)].name + " " + trace::name(event.kind) +
            " " + outcome.trace.statements[static_cast<std::size_t>(event.statement)].text + "\n";
  }
  return text;
}

ScriptedDevice sensor() {
  return {"sensor", {{"request x", true, {}}, {"x", false, {}}}};
}

// A asks the sensor for x and ends; with code 1 if there is no answer within 20 ms.
struct AskerInRealTime {
  explicit AskerInRealTime(bool within = false) {
    const int p = skill.processor("P");
    skill.devices = {"sensor"};
    const int request = skill.channel("A", "request x", "sensor");
    skill.channels.back().to_device = true;
    const int x = skill.channel("sensor", "x", "A");
    skill.channels.back().from_device = true;
    skill.channels.front().answer = x;
    const int act = skill.statement("act", 1ms);
    const int send = skill.statement("send", 1ms);
    const int receive = skill.statement("receive", 1ms);
    const int end = skill.statement("end", 1ms);
    skill.thread("A", p, 1, [=, this](Thread& t) -> Task {
      co_await t.perform(act, [this] {
        if (work) work();
      });
      co_await t.send(send, request);
      int taken = 0;
      if (within) {
        taken = co_await t.wait_within(receive, 20ms, from(x));
      } else {
        co_await t.wait(receive, from(x));
      }
      co_await t.complete(end, taken < 0 ? 1 : 0);
    });
  }
  WrittenSkill skill;
  std::function<void()> work;
};

}  // namespace

TEST_CASE("real time: where causes fix the order, messages come as in virtual time") {
  const bool together = GENERATE(false, true);
  TalkInRealTime in_virtual_time(200, true), in_real_time(200, together);
  if (!together) {  // the witness hears of a round at any time of the next one
    in_virtual_time.skill.threads[2].priority = in_real_time.skill.threads[2].priority = 3;
    in_virtual_time.skill.threads[0].processor = 0;
  }
  const auto expected = run(in_virtual_time.skill);
  const auto outcome = run(in_real_time.skill, {}, real_time());
  CAPTURE(outcome.reason);
  CHECK(outcome.code == 0);
  REQUIRE(outcome.real_time);
  CHECK(outcome.real_time->holds > 200);
  CHECK(messages(outcome) == messages(expected));
  const auto& asked = outcome.real_time->statements[1];
  CHECK(asked.count == 200);
}

TEST_CASE("real time: a more urgent thread interrupts an activity on a preemptive processor") {
  WrittenSkill skill;
  const int p = skill.processor("P");
  skill.devices = {"sensor"};
  const int x = skill.channel("sensor", "x", "HIGH");
  skill.channels.back().from_device = true;
  const int spin = skill.statement("spin", 1ms);
  const int receive = skill.statement("receive", 1ms);
  const int free = skill.statement("free", 1ms);
  const int end = skill.statement("end", 1ms);
  ScriptedDevice device("sensor", {{"x", false, {}}});
  std::atomic<bool> begun = false, freed = false;
  // Once LOW has begun, however late that is.
  std::function<void(runtime::DeviceHost&)> ring = [&](runtime::DeviceHost& host) {
    host.at(host.now() + 1ms, [&ring, &begun, &host] {
      if (!begun) return ring(host);
      host.deliver(0, {});
    });
  };
  device.on_open = ring;
  skill.thread("LOW", p, 1, [&](Thread& t) -> Task {
    // Comes to its end only if HIGH has the processor meanwhile.
    co_await t.perform(spin, [&] {
      begun = true;
      while (!freed) continue;
    });
    co_await t.complete(end, 0);
  });
  skill.thread("HIGH", p, 2, [&](Thread& t) -> Task {
    co_await t.wait(receive, from(x));
    co_await t.perform(free, [&] { freed = true; });
  });
  auto options = real_time();
  options.real_time->hang_timeout = 20s;
  options.real_time->fifo = GENERATE(true, false);
  const auto outcome = run(skill, {&device}, options);
  CAPTURE(outcome.reason);
  CHECK(outcome.code == 0);
  const std::string text = kinds(outcome);
  CHECK(text.find("LOW start spin\nLOW stop spin\nHIGH start receive\n") != std::string::npos);
  CHECK(text.find("HIGH done free\nLOW start spin\nLOW done spin\n") != std::string::npos);
}

TEST_CASE("real time: a processor that is not preemptive interrupts no thread") {
  WrittenSkill skill;
  const int p = skill.processor("P", false);
  const int go = skill.channel("LOW", "go", "HIGH");
  const int put = skill.statement("put", 1ms);
  const int act = skill.statement("act", 1ms);
  const int receive = skill.statement("receive", 1ms);
  const int end = skill.statement("end", 1ms);
  const int never = skill.channel("HIGH", "never", "LOW");
  skill.thread("LOW", p, 1, [=](Thread& t) -> Task {
    co_await t.send(put, go);
    co_await t.perform(act, [] {});
    co_await t.wait(receive, from(never));
  });
  skill.thread("HIGH", p, 2, [=](Thread& t) -> Task {
    co_await t.wait(receive, from(go));
    co_await t.complete(end, 0);
  });
  const auto outcome = run(skill, {}, real_time());
  CHECK(outcome.code == 0);
  const std::string text = kinds(outcome);
  CHECK(text.find(" stop ") == std::string::npos);
  CHECK(text.find("LOW done act") < text.find("HIGH start receive"));
}

TEST_CASE("real time: an exception of an activity or a device ends the skill, devices closed") {
  AskerInRealTime asker;
  ScriptedDevice device = sensor();
  std::string place;
  SECTION("an activity") {
    asker.work = [] { throw std::runtime_error("broken"); };
    place = "A at act (written.pal:1): broken";
  }
  SECTION("a device, as it receives") {
    device.on_receive = [](runtime::DeviceHost&, std::size_t, std::span<const double>) { throw 42; };
    place = "sensor: an exception that is not a std::exception";
  }
  SECTION("a device, later") {
    device.on_receive = [](runtime::DeviceHost& host, std::size_t, std::span<const double>) {
      host.at(host.now() + 1ms, [] { throw std::runtime_error("broken"); });
    };
    place = "sensor: broken";
  }
  SECTION("a device that reports a fault") {
    device.on_receive = [](runtime::DeviceHost& host, std::size_t, std::span<const double>) {
      host.fault("hot");
    };
    place = "sensor: hot";
  }
  const auto outcome = run(asker.skill, {&device}, real_time());
  CHECK(outcome.fault);
  CHECK(outcome.code == 9);
  CHECK(outcome.reason == place);
  CHECK(device.closed == 1);
}

TEST_CASE("real time: WITHIN, or the run's limit, gives up a device that never answers") {
  ScriptedDevice device = sensor();
  SECTION("WITHIN") {
    AskerInRealTime asker(true);
    const auto outcome = run(asker.skill, {&device}, real_time());
    CHECK_FALSE(outcome.fault);
    CHECK(outcome.code == 1);
  }
  SECTION("the limit") {
    AskerInRealTime asker;
    auto options = real_time();
    options.horizon = 200ms;  // long before, A waits: also on busy processors
    const auto outcome = run(asker.skill, {&device}, options);
    CHECK(outcome.fault);
    CHECK(outcome.reason == "the run is longer than its limit of 200 ms: A at receive (written.pal:3)");
  }
  CHECK(device.closed == 1);
}

TEST_CASE("real time: a device with a thread of its own posts into the run") {
  AskerInRealTime asker;
  ScriptedDevice device = sensor();
  std::thread own;
  device.on_receive = [&own](runtime::DeviceHost& host, std::size_t, std::span<const double>) {
    own = std::thread([&host] { host.post([&host] { host.deliver(1, {}); }); });
  };
  const auto outcome = run(asker.skill, {&device}, real_time());
  own.join();
  CHECK(outcome.code == 0);
}

TEST_CASE("real time: a stop from another thread ends the skill") {
  AskerInRealTime asker;
  ScriptedDevice device = sensor();
  runtime::RunControl control;
  auto options = real_time();
  options.control = &control;
  std::atomic<bool> begun = false;
  SECTION("while an activity runs") {
    asker.work = [&] {
      begun = true;
      while (!control.stopping()) continue;
    };
  }
  SECTION("while it waits") {
    device.on_receive = [&](runtime::DeviceHost&, std::size_t, std::span<const double>) { begun = true; };
  }
  SECTION("at an instant") {
    control.stop_at(1ms);
    begun = true;
  }
  std::thread stopper([&] {
    while (!begun) std::this_thread::yield();
    if (options.control->stop_instant() == runtime::Time::max()) control.stop();
  });
  const auto outcome = run(asker.skill, {&device}, options);
  stopper.join();
  CHECK(outcome.fault);
  CHECK(outcome.reason == "stopped on request");
  CHECK(device.closed == 1);
}

TEST_CASE("real time: a run cannot be held, says so, and goes on") {
  AskerInRealTime asker(true);
  ScriptedDevice device = sensor();
  runtime::RunControl control;
  auto options = real_time();
  options.control = &control;
  control.pause();
  control.break_at("M", 1);
  asker.work = [&control] { control.step(); };
  CHECK(run(asker.skill, {&device}, options).code == 1);
  CHECK(control.refusal() == "a run in real time cannot be held: its devices would not be answered");
  CHECK_FALSE(control.wait_for_halt(0ms));
}

TEST_CASE("real time: a deadlock is found and names the threads that wait") {
  WrittenSkill skill;
  const int p = skill.processor("P");
  const int q = skill.processor("Q");
  const int x = skill.channel("A", "x", "B");
  const int y = skill.channel("B", "y", "A");
  const int receive = skill.statement("receive", 1ms);
  skill.thread("A", p, 1, [=](Thread& t) -> Task { co_await t.wait(receive, from(y)); });
  skill.thread("B", q, 1, [=](Thread& t) -> Task { co_await t.wait(receive, from(x)); });
  const auto outcome = run(skill, {}, real_time());
  CHECK(outcome.fault);
  CHECK(outcome.reason ==
        "nothing is left to happen: A at receive (written.pal:1), B at receive (written.pal:1)");
}

TEST_CASE("real time: a skill that goes on and on without taking time is ended") {
  WrittenSkill skill;
  const int p = skill.processor("P");
  const int test = skill.statement("test");
  const int again = skill.condition("again");
  skill.thread("A", p, 1, [=](Thread& t) -> Task {
    for (;;) co_await t.test(test, again);
  });
  auto options = real_time();
  options.trace = runtime::TraceMode::none;
  const auto outcome = run(skill, {}, options);
  CHECK(outcome.fault);
  CHECK(outcome.reason == "the skill goes on and on without taking time: A at test (written.pal:1)");
}

TEST_CASE("real time: an exception of the world ends the skill") {
  struct Moving final : runtime::World {
    void advance_to(runtime::Time when) override {
      if (when < last) throw std::logic_error("back in time");
      last = when;
      ++steps;
      if (breaks && steps > 5) throw std::runtime_error("an earthquake");
    }
    runtime::Time beat() override { return 1ms; }
    runtime::Time last{};
    std::atomic<int> steps = 0;
    bool breaks = false;
  } world;
  AskerInRealTime asker;
  asker.work = [&world] {
    while (world.steps < 10 && !world.breaks) continue;
  };
  ScriptedDevice device = sensor();
  device.on_receive = [](runtime::DeviceHost& host, std::size_t, std::span<const double>) {
    host.at(host.now() + 10ms, [&host] { host.deliver(1, {}); });
  };
  world.breaks = GENERATE(false, true);
  runtime::Device* devices[] = {&device};
  const auto outcome = runtime::Dispatcher(devices, world).run(asker.skill, {}, real_time());
  CHECK(outcome.fault == world.breaks);
  CHECK(outcome.reason == (world.breaks ? "the world: an earthquake" : "done"));
}

TEST_CASE("real time: nothing is allocated between the first and the last message") {
  TalkInRealTime talk(500);
  talk.first = [] {
    reset_allocations();
    count_allocations(true);
  };
  talk.last = [] { count_allocations(false); };
  const auto outcome = run(talk.skill, {}, real_time());
  CHECK(outcome.code == 0);
  CHECK(outcome.trace.events.size() > 4000);
  CHECK(counted_allocations() == 0);
}

TEST_CASE("real time: a world that only advances is driven") {
  struct Simple final : runtime::World {
    void advance_to(runtime::Time when) override {
      ++calls;
      last = when;
    }
    int calls = 0;
    runtime::Time last{};
  } world;
  WrittenSkill skill;
  const int p = skill.processor("P");
  const int never = skill.channel("B", "never", "A");
  const int rest = skill.statement("rest", 1ms), end = skill.statement("end", 1ms);
  skill.thread("A", p, 1, [=](Thread& t) -> Task {
    co_await t.wait_within(rest, 100ms, from(never));
    co_await t.complete(end, 0);
  });
  const auto outcome = runtime::Dispatcher({}, world).run(skill, {}, real_time());
  CHECK_FALSE(outcome.fault);
  CHECK(world.calls > 3);
  CHECK(world.last > 50ms);
}

TEST_CASE("real time: threads of the system have names") {
  TalkInRealTime talk(1);
  std::array<char, 16> name{};
  talk.first = [&name] { ::pthread_getname_np(::pthread_self(), name.data(), name.size()); };
  NoWorld world;
  const auto outcome = runtime::Dispatcher({}, world).run(talk.skill, {}, real_time());
  CHECK_FALSE(outcome.fault);
  CHECK(std::string(name.data()) == "P 1");
}

TEST_CASE("real time: a request reaches an idle device at the instant at which it was put") {
  WrittenSkill skill;
  const int p = skill.processor("P");
  skill.devices = {"sensor"};
  const int request = skill.channel("A", "request x", "sensor");
  skill.channels.back().to_device = true;
  const int x = skill.channel("sensor", "x", "A");
  skill.channels.back().from_device = true;
  skill.channels.front().answer = x;
  const int send = skill.statement("send", 1s), receive = skill.statement("receive", 1s);
  skill.thread("A", p, 1, [=](Thread& t) -> Task {
    for (int i = 0; i < 50; ++i) {
      co_await t.send(send, request);
      co_await t.wait(receive, from(x));
    }
    co_await t.complete(send, 0);
  });
  const bool says_when_busy = GENERATE(true, false);
  ScriptedDevice device = sensor();
  device.on_receive = [&](runtime::DeviceHost& host, std::size_t, std::span<const double>) {
    if (says_when_busy) host.mark_busy(true);
    host.at(host.now() + 50us, [&host, says_when_busy] {
      if (says_when_busy) host.mark_busy(false);
      host.deliver(1, {});
    });
  };
  struct Handed final : runtime::MessageObserver {
    void passed(runtime::Time when, const runtime::Device&, std::size_t port,
                std::span<const double>) override {
      if (port == 0) at.push_back(when.count());
    }
    std::vector<std::int64_t> at;
  } handed;
  auto options = real_time();
  options.observer = &handed;
  const auto outcome = run(skill, {&device}, options);
  CHECK(outcome.code == 0);
  std::vector<std::int64_t> put, taken;
  for (const trace::Event& event : outcome.trace.events) {
    if (event.subject != request) continue;
    if (event.kind == trace::Kind::put) put.push_back(event.time_ns);
    if (event.kind == trace::Kind::take) taken.push_back(event.time_ns);
  }
  CHECK(put.size() == 50);
  CHECK(handed.at == put);
  if (says_when_busy) CHECK(taken == put);
}

TEST_CASE("real time: what the tolerance allows a device is no broken promise") {
  using Behaviour = runtime::DeviceTimes::Behaviour;
  const auto broken = [](runtime::Time tolerance) {
    WrittenSkill skill;
    const int p = skill.processor("P");
    skill.devices = {"sensor"};
    skill.times = {{.behaviour = Behaviour::on_request, .answer = {15ms, 16ms}}};
    const int request = skill.channel("A", "request x", "sensor");
    skill.channels.back().to_device = true;
    const int x = skill.channel("sensor", "x", "A");
    skill.channels.back().from_device = true;
    skill.channels.front().answer = x;
    const int send = skill.statement("send", 1s), receive = skill.statement("receive", 1s);
    skill.thread("A", p, 1, [=](Thread& t) -> Task {
      for (int i = 0; i < 2; ++i) {
        co_await t.send(send, request);
        co_await t.wait(receive, from(x));
      }
      co_await t.complete(send, 0);
    });
    ScriptedDevice device = sensor();
    bool late = false;
    device.on_receive = [&](runtime::DeviceHost& host, std::size_t, std::span<const double>) {
      host.at(host.now() + (std::exchange(late, true) ? 30ms : 1us), [&host] { host.deliver(1, {}); });
    };
    auto options = real_time();
    options.real_time->tolerance = tolerance;
    const auto outcome = run(skill, {&device}, options);
    CHECK(outcome.code == 0);
    return outcome.broken_promises.size();
  };
  CHECK(broken(0ms) == 2);  // one sooner, one later
  CHECK(broken(30s) == 0);
}

TEST_CASE("real time: what the tolerance allows a cost is no broken promise, and no activity has it") {
  const auto busy = [] {
    const auto from = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - from < 5ms) continue;
    return true;
  };
  const auto broken = [&](runtime::Time tolerance) {
    WrittenSkill skill;
    const int p = skill.processor("P");
    const int c = skill.condition("c");
    const int set = skill.statement("set", 1ms), act = skill.statement("act", 1ms),
              end = skill.statement("end", 1s);
    skill.thread("A", p, 1, [=](Thread& t) -> Task {
      co_await t.set(set, c, busy);
      co_await t.perform(act, busy);
      co_await t.complete(end, 0);
    });
    auto options = real_time();
    options.real_time->cost_tolerance = tolerance;
    std::vector<std::string> promises;
    for (const auto& each : run(skill, {}, options).broken_promises) promises.push_back(each.promise);
    return promises;
  };
  const std::string activity = "act of M (written.pal:2) takes at most 1 ms";
  CHECK(broken(0ms) == std::vector<std::string>{"set of M (written.pal:1) takes at most 1 ms", activity});
  CHECK(broken(1s) == std::vector<std::string>{activity});
  CHECK(broken(1ms).front() == "set of M (written.pal:1) takes at most 2 ms");
}

TEST_CASE("real time: an activity that waits holds its processor, and is late") {
  AskerInRealTime asker;
  asker.skill.times = {{}};
  std::binary_semaphore begun(0), released(0);
  asker.work = [&] {
    begun.release();
    released.acquire();  // longer than the millisecond that it may take
  };
  ScriptedDevice device = sensor();
  device.on_receive = [](runtime::DeviceHost& host, std::size_t, std::span<const double>) {
    host.deliver(1, {});
  };
  std::thread other([&] {
    begun.acquire();
    const auto from = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - from < 30ms) continue;
    released.release();
  });
  runtime::Measurement measurement(asker.skill.wiring());
  measurement.begin_run();
  auto options = real_time();
  options.work = &measurement;
  const auto outcome = run(asker.skill, {&device}, options);
  other.join();
  CHECK(outcome.code == 0);
  CHECK(outcome.real_time->statements[0].late == 1);
  REQUIRE(outcome.broken_promises.size() == 1);
  CHECK(outcome.broken_promises[0].promise == "act of M (written.pal:1) takes at most 1 ms");
  CHECK(outcome.broken_promises[0].measured > 1ms);
  const std::string text = measurement.environment();
  CHECK(text.find("  TIME act OF M : " + runtime::in_words(outcome.broken_promises[0].measured) +
                  "  # 1 time") != std::string::npos);
}

TEST_CASE("real time: what a more urgent thread takes is no part of an activity that waits") {
  WrittenSkill skill;
  const int p = skill.processor("P");
  skill.devices = {"sensor"};
  const int x = skill.channel("sensor", "x", "HIGH");
  skill.channels.back().from_device = true;
  const int wait = skill.statement("wait", 4s), receive = skill.statement("receive", 1s);
  const int work = skill.statement("work", 4s), end = skill.statement("end", 1s);
  ScriptedDevice device("sensor", {{"x", false, {}}});
  std::binary_semaphore begun(0), done(0);
  std::thread ring;
  device.on_open = [&](runtime::DeviceHost& host) {
    ring = std::thread([&] {
      begun.acquire();
      host.post([&host] { host.deliver(0, {}); });
    });
  };
  using Clock = std::chrono::steady_clock;
  Clock::time_point low_begun, low_ended, high_begun, high_ended;
  skill.thread("LOW", p, 1, [&](Thread& t) -> Task {
    co_await t.perform(wait, [&] {
      low_begun = Clock::now();
      begun.release();
      done.acquire();
      low_ended = Clock::now();
    });
    co_await t.complete(end, 0);
  });
  skill.thread("HIGH", p, 2, [&](Thread& t) -> Task {
    co_await t.wait(receive, from(x));
    co_await t.perform(work, [&] {
      high_begun = Clock::now();
      while (Clock::now() - high_begun < 20ms) continue;
      high_ended = Clock::now();
    });
    co_await t.perform(work, [&] { done.release(); });
  });
  const auto outcome = run(skill, {&device}, real_time());
  ring.join();
  CHECK(outcome.code == 0);
  const auto& times = outcome.real_time->statements[static_cast<std::size_t>(wait)];
  CHECK(times.count == 1);
  CHECK(times.greatest < (low_ended - low_begun) - (high_ended - high_begun));
}

TEST_CASE("real time: polling that was in vain is tried again after more and more waits") {
  runtime::LookOut look_out;
  const auto sleeps = [&look_out] {
    int waits = 0;
    while (!look_out.pays()) ++waits;
    return waits;
  };
  CHECK(sleeps() == 0);
  for (const int waits : {16, 32, 64}) {
    look_out.polled(false);
    CHECK(sleeps() == waits);
  }
  for (int i = 0; i < 63; ++i) look_out.polled(true);
  look_out.polled(false);
  CHECK(sleeps() == 128);
  for (int i = 0; i < 5 * 64; ++i) look_out.polled(true);
  look_out.polled(false);
  CHECK(sleeps() == 16);
  for (int i = 0; i < 40; ++i) look_out.polled(false);
  CHECK(sleeps() == 4096);
}

TEST_CASE("real time: once a skill is over time stands still, also for devices that are being closed") {
  struct Slow final : ScriptedDevice {
    using ScriptedDevice::ScriptedDevice;
    void attach(runtime::DeviceHost& host) override {
      ScriptedDevice::attach(host);
      run = &host;
    }
    void close() override {
      first = run->now();
      const auto begun = std::chrono::steady_clock::now();  // the watchdog looks each 5 ms
      while (std::chrono::steady_clock::now() - begun < 30ms) continue;
      second = run->now();
    }
    runtime::DeviceHost* run = nullptr;
    runtime::Time first{-1}, second{-2};
  } device{"sensor", {{"request x", true, {}}, {"x", false, {}}}};
  device.on_receive = [](runtime::DeviceHost& host, std::size_t, std::span<const double>) {
    host.deliver(1, {});
  };
  AskerInRealTime asker;
  const auto outcome = run(asker.skill, {&device}, real_time());
  CHECK(outcome.code == 0);
  CHECK(device.first == device.second);
  CHECK(outcome.duration == device.first);
}
