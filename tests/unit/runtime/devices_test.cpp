// Devices: opening, requests, overruns, faults, closing.
#include <catch2/catch.hpp>

#include "pal/runtime/serving_device.hpp"
#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
using runtime::DeviceHost;
using runtime::from;
using runtime::Task;
using runtime::Thread;

namespace {

// A reads the sensor as often as the test says.
struct Reader {
  Reader() {
    p = skill.processor("P");
    q = skill.processor("Q");
    skill.devices = {"sensor"};
    request = skill.channel("A", "request x", "sensor");
    skill.channels.back().to_device = true;
    x = skill.channel("sensor", "x", "A");
    skill.channels.back().from_device = true;
    skill.channels.front().answer = x;
    nap = skill.statement("nap", 2ms);
    send = skill.statement("send");
    receive = skill.statement("receive");
    end = skill.statement("end");
  }
  WrittenSkill skill;
  ScriptedDevice sensor{"sensor", {{"request x", true, {}}, {"x", false, {}}}};
  int p = 0, q = 0, request = 0, x = 0, nap = 0, send = 0, receive = 0, end = 0;
};

}  // namespace

TEST_CASE(
    "a device is opened by the first send to it, serves requests one at a time, and is closed at the end") {
  Reader bench;
  bool busy = false;
  int pending = 0;
  std::function<void(DeviceHost&)> serve = [&](DeviceHost& host) {
    busy = true;
    --pending;
    host.mark_busy(true);
    host.at(host.now() + 6ms, [&] {
      host.deliver(1, {});
      busy = false;
      host.mark_busy(false);
      if (pending > 0) serve(host);
    });
  };
  bench.sensor.on_receive = [&](DeviceHost& host, std::size_t, std::span<const double>) {
    ++pending;
    if (!busy) serve(host);
  };
  bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task {
    co_await t.perform(bench.nap, [] {});
    for (int i = 0; i < 3; ++i) co_await t.send(bench.send, bench.request);
    for (int i = 0; i < 3; ++i) co_await t.wait(bench.receive, from(bench.x));
    co_await t.complete(bench.end, 0);
  });
  const auto outcome = run(bench.skill, {&bench.sensor});
  CHECK(outcome.code == 0);
  CHECK(bench.sensor.opened == 1);
  CHECK(bench.sensor.opened_at == 2ms);
  CHECK(bench.sensor.closed == 1);
  CHECK(only(to_text(outcome.trace), {"put", "take", "busy", "idle"}) ==
        "2 put A send <request x>\n"
        "2 busy sensor\n"
        "2 take sensor <request x>\n"
        "2 put A send <request x>\n"
        "8 put sensor <x>\n"
        "8 idle sensor\n"
        "8 busy sensor\n"
        "8 take sensor <request x>\n"
        "8 put A send <request x>\n"
        "8 take A receive <x>\n"
        "14 put sensor <x>\n"
        "14 idle sensor\n"
        "14 busy sensor\n"
        "14 take sensor <request x>\n"
        "14 take A receive <x>\n"
        "20 put sensor <x>\n"
        "20 idle sensor\n"
        "20 take A receive <x>\n");
}

TEST_CASE("an event that finds its slot full is an overrun and is lost") {
  Reader bench;
  bench.skill.channels.front().answer = -1;  // the device sends by itself
  bool last = true;
  bench.sensor.on_open = [&](DeviceHost& host) {
    for (int i = 0; i < 3; ++i) {
      host.at(host.now() + 10ms + i * 1ms, [&] { last = host.deliver(1, {}); });
    }
  };
  const int long_nap = bench.skill.statement("long-nap", 30ms);
  bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task {
    co_await t.perform(bench.nap, [] {});
    co_await t.wait(bench.receive, from(bench.x));
    co_await t.perform(long_nap, [] {});
    co_await t.complete(bench.end, 0);
  });
  const auto outcome = run(bench.skill, {&bench.sensor});
  CHECK(outcome.overruns == 1);
  CHECK(!last);
  CHECK(only(to_text(outcome.trace), {"put", "take", "overrun"}) ==
        "12 put sensor <x>\n"
        "12 take A receive <x>\n"
        "13 put sensor <x>\n"
        "14 overrun sensor <x>\n");
}

TEST_CASE("the answer of a device to a withdrawn request is discarded") {
  Reader bench;
  bench.sensor.on_receive = [&](DeviceHost& host, std::size_t, std::span<const double>) {
    host.mark_busy(true);
    host.at(host.now() + 6ms, [&host] {
      host.mark_busy(false);
      host.deliver(1, {});
    });
  };
  std::vector<int> taken;
  bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task {
    co_await t.send(bench.send, bench.request);
    taken.push_back(co_await t.wait_within(bench.receive, 1ms, from(bench.x)));
    for (int i = 0; i < 3; ++i) co_await t.perform(bench.nap, [] {});
    co_await t.send(bench.send, bench.request);
    taken.push_back(co_await t.wait_within(bench.receive, 7ms, from(bench.x)));
    co_await t.complete(bench.end, 0);
  });
  CHECK(only(to_text(run(bench.skill, {&bench.sensor}).trace), {"put sensor", "drop", "overrun"}) ==
        "6 drop sensor <x>\n"
        "13 put sensor <x>\n");
  CHECK(taken == std::vector<int>{-1, 0});
}

TEST_CASE("a request that is withdrawn while it waits at a busy device is not served") {
  Reader bench;
  int pending = 0;
  bool busy = false;
  std::function<void(DeviceHost&)> serve = [&](DeviceHost& host) {
    busy = true;
    --pending;
    host.mark_busy(true);
    host.at(host.now() + 6ms, [&] {
      busy = false;
      host.mark_busy(false);
      host.deliver(1, {});
      if (pending > 0 && !busy) serve(host);
    });
  };
  bench.sensor.on_receive = [&](DeviceHost& host, std::size_t, std::span<const double>) {
    ++pending;
    if (!busy) serve(host);
  };
  bench.sensor.on_withdraw = [&](std::size_t) {
    --pending;
    return true;
  };
  std::vector<int> taken;
  bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task {
    co_await t.send(bench.send, bench.request);
    co_await t.send(bench.send, bench.request);
    taken.push_back(co_await t.wait_within(bench.receive, 1ms, from(bench.x)));
    co_await t.perform(bench.nap, [] {});
    co_await t.send(bench.send, bench.request);
    taken.push_back(co_await t.wait_within(bench.receive, 20ms, from(bench.x)));
    co_await t.complete(bench.end, 0);
  });
  CHECK(only(to_text(run(bench.skill, {&bench.sensor}).trace), {"take sensor", "put sensor", "drop"}) ==
        "0 take sensor <request x>\n"
        "1 drop <request x>\n"
        "6 drop sensor <x>\n"
        "6 take sensor <request x>\n"
        "12 put sensor <x>\n");
  CHECK(taken == std::vector<int>{-1, 0});
}

TEST_CASE("every fault ends the skill with its error completion and closes the devices") {
  Reader bench;
  std::string expected;
  runtime::RunOptions options;
  std::vector<runtime::Device*> devices{&bench.sensor};

  SECTION("an activity that throws") {
    bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task {
      co_await t.wait_within(bench.receive, 1ms, from(bench.x));
      co_await t.perform(bench.nap, [] { throw std::runtime_error("no such surface"); });
    });
    expected = "A at nap (written.pal:1): no such surface";
  }
  SECTION("a device that reports a fault") {
    bench.sensor.on_open = [&](DeviceHost& host) {
      host.at(host.now() + 1ms, [&host] { host.fault("overload"); });
    };
    bench.skill.thread("A", bench.p, 1,
                       [&](Thread& t) -> Task { co_await t.wait(bench.receive, from(bench.x)); });
    expected = "sensor: overload";
  }
  SECTION("a device that throws") {
    bench.sensor.on_open = [](DeviceHost&) { throw std::runtime_error("no cable"); };
    bench.skill.thread("A", bench.p, 1,
                       [&](Thread& t) -> Task { co_await t.wait(bench.receive, from(bench.x)); });
    expected = "sensor: no cable";
  }
  SECTION("a device that throws later") {
    bench.sensor.on_open = [](DeviceHost& host) {
      host.at(host.now() + 1ms, [] { throw std::runtime_error("cable cut"); });
    };
    bench.skill.thread("A", bench.p, 1,
                       [&](Thread& t) -> Task { co_await t.wait(bench.receive, from(bench.x)); });
    expected = "sensor: cable cut";
  }
  SECTION("a run that is too long") {
    options.horizon = 100ms;
    bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task {
      for (;;) co_await t.perform(bench.nap, [] {});
    });
    expected = "the run is longer than its limit of 100 ms: A at nap (written.pal:1)";
  }
  SECTION("a run in which time stands still") {
    bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task {
      for (;;) co_await t.perform(bench.end, [] {});
    });
    options.trace_capacity = 1;
    expected = "the skill goes on and on without taking time: A at end (written.pal:4)";
  }
  SECTION("deadlock") {
    bench.skill.thread("A", bench.p, 1,
                       [&](Thread& t) -> Task { co_await t.wait(bench.receive, from(bench.x)); });
    expected = "nothing is left to happen: A at receive (written.pal:3)";
  }
  SECTION("no arm of a CASE holds") {
    bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task { co_await t.no_arm_holds(bench.nap); });
    expected = "A at nap (written.pal:1): no arm holds";
  }
  const auto outcome = run(bench.skill, devices, options);
  CHECK(outcome.fault);
  CHECK(outcome.code == 9);
  CHECK(outcome.reason == expected);
  CHECK(bench.sensor.closed == 1);
  REQUIRE(outcome.trace.faults.size() == 1);
  CHECK(outcome.trace.faults[0] == expected);
  CHECK(outcome.trace.events.back().kind == trace::Kind::complete);
}

TEST_CASE("a device cancels an appointment: it is not called, and no run waits for it") {
  Reader bench;
  std::vector<int> called;
  DeviceHost::Appointment late, again;
  bench.sensor.on_receive = [&](DeviceHost& host, std::size_t, std::span<const double>) {
    const auto call = [&](int number) { return [&called, number] { called.push_back(number); }; };
    const auto first = host.at(host.now() + 1ms, call(1));
    host.at(host.now() + 1ms, call(2));
    host.cancel(first);
    host.cancel(first);                          // twice does no harm
    again = host.at(host.now() + 1ms, call(3));  // may have its place: it is another appointment
    host.cancel(first);
    late = host.at(host.now() + 1h, call(4));
    host.at(host.now() + 2ms, [&] {
      host.cancel(again);  // has been called: too late
      host.cancel(late);
      host.cancel({});
    });
  };
  bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task {
    co_await t.send(bench.send, bench.request);
    co_await t.wait(bench.receive, from(bench.x));
  });
  const auto outcome = run(bench.skill, {&bench.sensor});
  CHECK(called == std::vector<int>{2, 3});
  // The answer never comes. That is found when the last appointment has been kept, not an hour later.
  CHECK(outcome.reason.find("nothing is left to happen") == 0);
  CHECK(outcome.duration == 2ms);
}

TEST_CASE("a skill does not begin without its devices") {
  Reader bench;
  bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task { co_await t.complete(bench.end, 0); });
  SECTION("missing") {
    CHECK(run(bench.skill).reason == "there is no device sensor; no device was given");
  }
  SECTION("with other fields") {
    ScriptedDevice other("sensor", {{"request x", true, {}}, {"x", false, {{"fz", "N"}}}});
    CHECK(run(bench.skill, {&other}).reason ==
          "device sensor does not send x with no fields: its message has 1 field, not 0");
    CHECK(other.closed == 0);
  }
}

namespace {

/// Answers each request after 6 ms, and never marks itself.
class Slow final : public runtime::ServingDevice {
 public:
  Slow() : ServingDevice("sensor", {{"request x", true, {}}, {"x", false, {}}}) {}
  void receive(std::size_t, std::span<const double>) override {
    asked();
    ++pending_;
    if (pending_ == 1) work();
  }

 private:
  void work() {
    after(6ms, [this] {
      answer(1, {});
      if (--pending_ > 0) work();
    });
  }
  int pending_ = 0;
};

}  // namespace

TEST_CASE("a serving device is busy from each request that it begins with to its answer") {
  Reader bench;
  Slow slow;
  bench.skill.thread("A", bench.p, 1, [&](Thread& t) -> Task {
    for (int i = 0; i < 2; ++i) co_await t.send(bench.send, bench.request);
    for (int i = 0; i < 2; ++i) co_await t.wait(bench.receive, from(bench.x));
    co_await t.complete(bench.end, 0);
  });
  const auto outcome = run(bench.skill, {&slow});
  CHECK(outcome.code == 0);
  CHECK(only(to_text(outcome.trace), {"busy", "idle"}) ==
        "0 busy sensor\n"
        "6 idle sensor\n"
        "6 busy sensor\n"
        "12 idle sensor\n");
}

TEST_CASE("a device that does something every so often names each instant, not the time since the last") {
  WrittenSkill skill;
  const int p = skill.processor("P");
  skill.devices = {"clock"};
  const int tick = skill.channel("clock", "tick", "A");
  skill.channels.back().from_device = true;
  const int hear = skill.statement("hear");
  const int end = skill.statement("end");
  skill.thread("A", p, 1, [=](Thread& t) -> Task {
    for (int i = 0; i < 3; ++i) co_await t.wait(hear, runtime::from(tick));
    co_await t.complete(end, 0);
  });
  struct Ticking final : runtime::PortDevice {
    Ticking() : PortDevice("clock", {{"tick", false, {}}}) {}
    void receive(std::size_t, std::span<const double>) override {}
    void open() override {
      every(10ms, 3ms, [this] {
        at.push_back(now());
        host().deliver(0, {});
      });
    }
    std::vector<runtime::Time> at;
  } clock;
  CHECK(run(skill, {&clock}).code == 0);
  CHECK(clock.at == std::vector<runtime::Time>{3ms, 13ms, 23ms});
}
