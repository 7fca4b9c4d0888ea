// What is measured of devices and of code written by hand, and how it is written down.
#include "pal/runtime/measurement.hpp"

#include <catch2/catch.hpp>
#include <semaphore>
#include <thread>

#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
using runtime::ChannelSpec;
using runtime::Extremes;
using runtime::Measurement;
using runtime::Time;

namespace {

constexpr runtime::ProcessorSpec processors[] = {{"P0", true}, {"P1", false}};
constexpr runtime::StatementSpec statements[] = {{"LS1", "scale", "", 1, {}},
                                                 {"LS1", "scale", "", 4, {}},
                                                 {"SM1", "scale", "", 9, {}},
                                                 {"SM1", "SPC( near )", "", 10, {}},
                                                 {"SM1", "TXM( step to MC1 )", "", 11, {}},
                                                 {"SM1", "CASE", "", 12, {}},
                                                 {"SM1", "WTM( a from b )", "", 13, {}}};
constexpr std::string_view devices[] = {"gauge", "clock", "lamp"};

/// Requests for a and b of the gauge, ticks of the clock, light for the lamp.
struct Cell {
  Cell() {
    const auto to = [](const char* message, const char* device, int answer) {
      return ChannelSpec{"SD1", message, device, {}, answer, answer >= 0, false, true};
    };
    const auto from = [](const char* device, const char* message) {
      return ChannelSpec{device, message, "SD1", {}, -1, false, true, false};
    };
    channels = {to("request a", "gauge", 1), from("gauge", "a"),    to("request b", "gauge", 3),
                from("gauge", "b"),          from("clock", "tick"), to("light", "lamp", -1)};
    wiring.skill = "weigh";
    wiring.environment = "bench";
    wiring.processors = processors;
    wiring.statements = statements;
    wiring.channels = channels;
    wiring.devices = devices;
  }
  std::vector<ChannelSpec> channels;
  runtime::Wiring wiring;
  ScriptedDevice gauge{
      "gauge", {{"request a", true, {}}, {"a", false, {}}, {"request b", true, {}}, {"b", false, {}}}};
  ScriptedDevice clock{"clock", {{"other", false, {}}, {"tick", false, {}}}};
};

bool has(const std::string& text, const std::string& line) {
  return text.find("\n" + line + "\n") != std::string::npos;
}

}  // namespace

TEST_CASE("an answer counts from its request, or from the last answer") {
  Cell cell;
  Measurement measurement(cell.wiring);
  measurement.begin_run();
  const auto pass = [&](Time when, std::size_t port) { measurement.passed(when, cell.gauge, port, {}); };
  SECTION("one at a time") {
    pass(1ms, 0);
    pass(6ms, 1);  // 5 ms
    pass(10ms, 2);
    pass(17ms, 3);  // 7 ms
    CHECK(has(measurement.environment(), "  DEVICE gauge ON REQUEST 5 TO 7 ms  # 2 answers"));
  }
  SECTION("one that waits for its turn") {
    pass(1ms, 0);
    pass(2ms, 2);
    pass(6ms, 1);   // 5 ms
    pass(12ms, 3);  // 6 ms after the last answer
    CHECK(has(measurement.environment(), "  DEVICE gauge ON REQUEST 5 TO 6 ms  # 2 answers"));
  }
  SECTION("two that are answered together count once") {
    pass(1ms, 0);
    pass(3ms, 2);
    pass(6ms, 1);
    pass(6ms, 3);
    CHECK(has(measurement.environment(), "  DEVICE gauge ON REQUEST 5 ms  # 1 answer"));
  }
  SECTION("one that is withdrawn has no answer") {
    pass(1ms, 0);
    measurement.forgotten(cell.gauge, 0);
    pass(50ms, 0);
    pass(55ms, 1);
    CHECK(has(measurement.environment(), "  DEVICE gauge ON REQUEST 5 ms  # 1 answer"));
  }
  SECTION("what a run leaves open is not answered in the next") {
    pass(90ms, 0);
    measurement.begin_run();
    pass(1ms, 0);
    pass(4ms, 1);
    CHECK(has(measurement.environment(), "  DEVICE gauge ON REQUEST 3 ms  # 1 answer"));
    CHECK(measurement.environment().starts_with("# Measured in 2 runs of skill weigh.\n"));
  }
  SECTION("an answer without a request is none") {
    pass(4ms, 1);
    CHECK(has(measurement.environment(), "  # not measured: device gauge"));
  }
}

TEST_CASE("intervals of events count within one run only") {
  Cell cell;
  Measurement measurement(cell.wiring);
  for (const Time begin : {0ms, 3ms}) {
    measurement.begin_run();
    for (const Time late : {0us, 300us, -200us}) {
      static int number = 0;
      measurement.passed(begin + 10ms * ++number + late, cell.clock, 1, {});
    }
  }
  // 10.3 and 9.5 ms apart: 9.9 ms with 0.4 ms more or less.
  CHECK(has(measurement.environment(),
            "  DEVICE clock EVENT tick EVERY 9.9 ms JITTER 400 us  # 9.5 ms to 10.3 ms apart, 4 times"));
}

TEST_CASE("times are summed up by activity and module, decisions and messages by their cost") {
  Cell cell;
  Measurement measurement(cell.wiring);
  measurement.worked(0, 310ns);
  measurement.worked(1, 5200ns);
  measurement.worked(1, 400ns);
  measurement.worked(3, 80ns);
  measurement.worked(4, 2ms);
  const std::string text = measurement.environment();
  CHECK(has(text, "  TIME scale OF LS1 : 0.31 TO 5.2 us  # 3 times"));
  CHECK(has(text, "  # not reached: scale OF SM1"));
  CHECK(has(text, "  COST SET 80 ns  # 1 time, the decisions alone"));
  CHECK(has(text, "  COST SEND 2 ms  # 1 time, making and packing of messages alone"));
  CHECK(has(text, "  PROCESSOR P1 NONPREEMPTIVE"));
  CHECK(text.find("CASE") == std::string::npos);
}

TEST_CASE("extremes are right when several threads add to them") {
  Extremes extremes;
  CHECK(extremes.least() == Time::zero());
  {
    std::vector<std::jthread> threads;
    for (int t = 1; t <= 4; ++t)
      threads.emplace_back([&extremes, t] {
        for (int i = 1; i <= 1000; ++i) extremes.add(Time(i * t));
      });
  }
  CHECK(extremes.count() == 4000);
  CHECK(extremes.least() == Time(1));
  CHECK(extremes.greatest() == Time(4000));
}

TEST_CASE("a run tells its observers of devices and of code written by hand") {
  WrittenSkill skill;
  skill.devices = {"sensor"};
  const int p = skill.processor("P");
  const int request = skill.channel("A", "request x", "sensor");
  skill.channels.back().to_device = true;
  skill.channels.back().request = true;
  const int x = skill.channel("sensor", "x", "A");
  skill.channels.back().from_device = true;
  skill.channels.front().answer = x;
  const int work = skill.statement("work", 1ms), send = skill.statement("TXM( request x to sensor )"),
            receive = skill.statement("WTM( x from sensor )"), end = skill.statement("end");
  ScriptedDevice sensor("sensor", {{"request x", true, {}}, {"x", false, {}}});
  sensor.on_receive = [](runtime::DeviceHost& host, std::size_t, std::span<const double>) {
    host.at(host.now() + 4ms, [&host] { host.deliver(1, {}); });
  };
  double sum = 0;
  skill.thread("A", p, 1, [&](runtime::Thread& t) -> runtime::Task {
    for (int i = 0; i < 3; ++i) {
      co_await t.perform(work, [&sum] {
        for (int k = 1; k < 100'000; ++k) sum += 1.0 / k;
      });
      co_await t.send(send, request);
      co_await t.wait(receive, runtime::from(x));
    }
    co_await t.complete(end, 0);
  });
  Measurement measurement(skill.wiring());
  measurement.begin_run();
  const auto outcome = test::run(skill, {&sensor}, {.observer = &measurement, .work = &measurement});
  CHECK(outcome.code == 0);
  CHECK(sum > 0);
  const std::string text = measurement.environment();
  CHECK(has(text, "  DEVICE sensor ON REQUEST 4 ms  # 3 answers"));
  CHECK_THAT(text, Catch::Contains("  TIME work OF ") && Catch::Contains("  # 3 times\n"));
  // A signal is not written by hand.
  CHECK_THAT(text, !Catch::Contains("\n  COST "));
}

TEST_CASE("code that waits holds its processor for as long as it waits") {
  WrittenSkill skill;
  const int p = skill.processor("P");
  const int act = skill.statement("act", 1ms), end = skill.statement("end", 1ms);
  std::binary_semaphore begun(0), released(0);
  std::thread other([&] {
    begun.acquire();
    const auto from = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - from < 30ms) continue;
    released.release();
  });
  skill.thread("A", p, 1, [&](runtime::Thread& t) -> runtime::Task {
    co_await t.perform(act, [&] {
      begun.release();
      released.acquire();
    });
    co_await t.complete(end, 0);
  });
  struct Work final : runtime::WorkObserver {
    void worked(int statement, Time time) override {
      if (statement == 0) greatest = time;
    }
    Time greatest{};
  } work;
  runtime::RunOptions options;
  options.work = &work;
  CHECK(run(skill, {}, options).code == 0);
  other.join();
  CHECK(work.greatest >= 30ms);
}
