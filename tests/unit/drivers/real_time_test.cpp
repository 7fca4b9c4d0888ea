// Stations whose skill runs in real time: physics and devices in one thread, the kernel in others.
#include <atomic>
#include <catch2/catch.hpp>

#include "runtime/drivers/linked_driver.hpp"
#include "runtime/drivers/station.hpp"
#include "runtime/drivers/wire.hpp"
#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
using runtime::from;
using runtime::Task;
using runtime::Thread;
using runtime::Time;
using runtime::drivers::Bytes;

namespace {

/// Answers each request with a byte that comes back over a line.
class EchoDriver final : public runtime::drivers::LinkedDriver {
 public:
  EchoDriver(runtime::drivers::Timeline& timeline, runtime::drivers::Link& link)
      : LinkedDriver(timeline, link, "echo", {{"request x", true, {}}, {"x", false, {{"n", ""}}}}) {}
  bool ready() const override { return true; }
  void open() override { ++opened; }
  void receive(std::size_t, std::span<const double>) override {
    if (broken) throw std::runtime_error("no echo");
    const std::uint8_t byte = sent++;
    write({&byte, 1});
    await(100ms);
  }
  void close() override {
    ++closed;
    LinkedDriver::close();
  }
  int opened = 0, closed = 0;
  bool broken = false;

 private:
  void arrived(Bytes bytes) override {
    arrived_in_time();
    const double n = bytes[0];
    if (host() != nullptr) host()->deliver(1, {&n, 1});
  }
  void give_up() override {}
  std::string missing() const override { return "no byte came"; }
  std::uint8_t sent = 0;
};

/// The far end of the line.
struct Mirror final : runtime::drivers::LinkUser {
  Mirror(runtime::drivers::Link& line) : link(line) { link.connect(this); }
  void on_bytes(Bytes bytes) override { link.write(bytes); }
  void on_break(std::string_view) override {}
  runtime::drivers::Link& link;
};

struct Number {
  static constexpr std::size_t field_count = 1;
  double n = 0;
  static Number from_fields(std::span<const double> fields) { return {fields[0]}; }
};

// A asks the echo `rounds` times, with an activity after each.
struct Asker {
  explicit Asker(int rounds) {
    const int p = skill.processor("P");
    skill.devices = {"echo"};
    const int request = skill.channel("A", "request x", "echo");
    skill.channels.back().to_device = true;
    const int x = skill.channel("echo", "x", "A");
    skill.channels.back().from_device = true;
    skill.channels.back().fields = fields;
    skill.channels.front().answer = x;
    const int send = skill.statement("send", 1s);
    const int receive = skill.statement("receive", 1s);
    const int act = skill.statement("act", 1s);
    skill.thread("A", p, 1, [=, this](Thread& t) -> Task {
      for (int i = 0; i < rounds; ++i) {
        co_await t.send(send, request);
        co_await t.wait(receive, from(x, number));
        co_await t.perform(act, [this] {
          sum += number.n;
          if (work) work();
        });
      }
      co_await t.complete(send, 0);
    });
  }
  std::array<runtime::Field, 1> fields{runtime::Field{"n", ""}};
  WrittenSkill skill;
  Number number;
  double sum = 0;
  std::function<void()> work;
};

struct Physics : runtime::World {
  void advance_to(Time when) override {
    if (when < last) throw std::logic_error("back in time");
    last = when;
    if (moved) moved();
  }
  Time last{};
  std::function<void()> moved;
};

struct Bench {
  Physics physics;
  runtime::drivers::Station station{physics};
  runtime::drivers::Wire wire{station.timeline(), {1e6, 10}};
  Mirror mirror{wire.b()};
  EchoDriver driver{station.timeline(), wire.a()};
  Bench() { station.add(driver); }
  runtime::Outcome run(runtime::Skill& skill) {
    runtime::drivers::SessionOptions options;
    options.run.real_time.emplace();
    options.run.horizon = 8s;
    return station.run(skill, {}, options);
  }
};

}  // namespace

TEST_CASE("real time: a station's devices answer over their lines, skill after skill", "[station]") {
  Bench bench;
  for (int run = 1; run <= 2; ++run) {
    Asker asker(20);
    const auto outcome = bench.run(asker.skill);
    CAPTURE(outcome.reason);
    CHECK(outcome.code == 0);
    CHECK(asker.sum == (run == 1 ? 190 : 590));
    CHECK(bench.driver.opened == run);
    CHECK(bench.driver.closed == run);
    bench.station.idle(10ms);
  }
}

TEST_CASE("real time: the kernel is free while the physics moves", "[station]") {
  Bench bench;
  Asker asker(3);
  // The physics waits for an activity that begins meanwhile: with the kernel held neither would go on.
  std::atomic<int> acted = 0, seen = 0, waited = 0;
  asker.work = [&] {
    const int before = seen;
    ++acted;
    while (seen == before) continue;
  };
  bench.physics.moved = [&] {
    if (acted == seen) return;
    ++waited;
    seen = acted.load();
  };
  const auto outcome = bench.run(asker.skill);
  CAPTURE(outcome.reason);
  CHECK(outcome.code == 0);
  CHECK(waited == 3);
}

TEST_CASE("real time: an exception of a station's device or physics ends the skill", "[station]") {
  Bench bench;
  Asker asker(5);
  std::string reason;
  SECTION("a device") {
    bench.driver.broken = true;
    reason = "echo: no echo";
  }
  SECTION("a device that is not answered") {
    bench.mirror.link.connect(nullptr);
    reason = "echo: no byte came within 100 ms; is it switched on, and is its cable plugged in?";
  }
  SECTION("the physics") {
    bench.physics.moved = [&] {
      if (bench.driver.opened > 0) throw std::runtime_error("an earthquake");
    };
    reason = "the world: an earthquake";
  }
  const auto outcome = bench.run(asker.skill);
  CHECK(outcome.fault);
  CHECK(outcome.reason == reason);
  CHECK(bench.driver.closed == 1);
}
