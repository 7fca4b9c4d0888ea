// What must not happen: exceptions that leave a run, a run in a run, a run that cannot be stopped.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <thread>
#include <utility>

#include "pal/runtime/dispatcher.hpp"
#include "pal/runtime/payload.hpp"
#include "pal/runtime/run_control.hpp"
#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
using runtime::DeviceHost;
using runtime::from;
using runtime::Task;
using runtime::Thread;

namespace {

// Throws what is no std::exception, wherever it is told to.
struct Thrower final : runtime::Device {
  enum class Where { attach, open, receive, action, close, nowhere };
  explicit Thrower(Where place) : where(place) {}
  const std::string& name() const override { return name_; }
  const std::vector<runtime::PortSpec>& ports() const override { return ports_; }
  void attach(DeviceHost& host) override {
    host_ = &host;
    go(Where::attach);
  }
  void open() override { go(Where::open); }
  void receive(std::size_t, std::span<const double>) override {
    go(Where::receive);
    if (on_receive) on_receive();
    host_->at(host_->now() + 1ms, [this] {
      go(Where::action);
      host_->deliver(1, {});
    });
  }
  void close() override {
    closed = true;
    go(Where::close);
  }
  void go(Where place) const {
    if (place == where) throw 42;
  }
  Where where;
  std::function<void()> on_receive;
  bool closed = false;

 private:
  std::string name_ = "sensor";
  std::vector<runtime::PortSpec> ports_{{"request x", true, {}}, {"x", false, {}}};
  DeviceHost* host_ = nullptr;
};

// Has nothing to do.
struct Named : runtime::Device {
  explicit Named(std::string name) : name_(std::move(name)) {}
  const std::string& name() const override { return name_; }
  const std::vector<runtime::PortSpec>& ports() const override { return ports_; }
  void attach(DeviceHost&) override { attached = true; }
  void open() override {}
  void receive(std::size_t, std::span<const double>) override {}
  void close() override {
    ++closed;
    if (throws_at_close) throw std::runtime_error("stuck");
  }
  bool attached = false, throws_at_close = false;
  int closed = 0;

 private:
  std::string name_;
  std::vector<runtime::PortSpec> ports_;
};

// A asks the sensor for x and ends.
struct RefusedAsker {
  RefusedAsker() {
    const int p = skill.processor("P");
    skill.devices = {"sensor"};
    request = skill.channel("A", "request x", "sensor");
    skill.channels.back().to_device = true;
    x = skill.channel("sensor", "x", "A");
    skill.channels.back().from_device = true;
    skill.channels.front().answer = x;
    send = skill.statement("send");
    receive = skill.statement("receive");
    end = skill.statement("end");
    skill.thread("A", p, 1, [this](Thread& t) -> Task {
      co_await t.send(send, request);
      co_await t.wait(receive, from(x));
      co_await t.complete(end, 0);
    });
  }
  WrittenSkill skill;
  int request = 0, x = 0, send = 0, receive = 0, end = 0;
};

}  // namespace

TEST_CASE("nothing that a device throws leaves a run, and the device is closed") {
  using Where = Thrower::Where;
  for (const Where where : {Where::attach, Where::open, Where::receive, Where::action, Where::close}) {
    CAPTURE(static_cast<int>(where));
    RefusedAsker asker;
    Thrower sensor(where);
    const auto outcome = run(asker.skill, {&sensor});
    CHECK(outcome.fault);
    CHECK(outcome.reason.find("sensor: an exception that is not a std::exception") != std::string::npos);
    CHECK(sensor.closed == (where != Where::attach));
  }
}

TEST_CASE("only devices that were attached are closed, whatever they throw") {
  struct Nameless final : Named {
    using Named::Named;
    const std::string& name() const override {
      if (attached) throw std::runtime_error("no name");
      return Named::name();
    }
  };
  RefusedAsker asker;
  asker.skill.devices = {"first", "sensor", "last"};
  Nameless first("first");
  Thrower sensor(Thrower::Where::attach);
  Named last("last");
  const auto outcome = run(asker.skill, {&first, &sensor, &last});
  CHECK(outcome.fault);
  CHECK(outcome.reason == "sensor: an exception that is not a std::exception");
  CHECK(first.closed == 1);
  CHECK_FALSE(sensor.closed);
  CHECK(last.closed == 0);

  // One whose close() throws does not keep the others open, though it has no name any more.
  asker.skill.devices = {"sensor", "first", "last"};
  Thrower calm(Thrower::Where::nowhere);
  Nameless second("first");
  second.throws_at_close = true;
  Named third("last");
  const auto closed = run(asker.skill, {&calm, &second, &third});
  CHECK(closed.fault);
  CHECK(closed.reason.find("first") != std::string::npos);
  CHECK(third.closed == 1);
}

TEST_CASE("a part that is null, and times that are nothing or without end, are refused with words") {
  RefusedAsker asker;
  Thrower sensor(Thrower::Where::nowhere);
  const auto reason = [&](const std::function<void(runtime::RunOptions&)>& change) {
    runtime::RunOptions options;
    options.real_time.emplace();
    change(options);
    const auto outcome = run(asker.skill, {&sensor}, options);
    CHECK(outcome.fault);
    return outcome.reason;
  };
  CHECK(run(asker.skill, {&sensor, nullptr}).reason == "device 2 is null");
  CHECK(reason([](auto& options) { options.horizon = 0s; }) ==
        "horizon is 0 ns; it must be more than nothing");
  CHECK(reason([](auto& options) { options.horizon = runtime::Time::max(); }) ==
        "horizon is longer than 100 years");
  CHECK(reason([](auto& options) { options.real_time->hang_timeout = 0s; }) ==
        "hang_timeout is 0 ns; it must be more than nothing, and at most 100 years");
  CHECK(reason([](auto& options) {
          options.real_time->hang_timeout = std::chrono::milliseconds::max();
        }).starts_with("hang_timeout is "));
  CHECK(reason([](auto& options) { options.real_time->look_out = -1ns; }) ==
        "look_out is -1 ns; it must not be negative, and be at most 100 years");
}

TEST_CASE("a world whose time goes back, or runs ahead, ends the skill") {
  struct Odd final : runtime::World {
    explicit Odd(runtime::Time how_far) : by(how_far) {}
    void advance_to(runtime::Time) override {}
    runtime::Time wait_until(runtime::Time when) override { return when > 0ms ? when + by : when; }
    runtime::Time by;
  };
  const auto [by, why] = GENERATE(std::pair{-2ms, "the world: wait_until() goes back, from 0 ns to -1 ms"},
                                  std::pair{1ms, "the world: wait_until() goes beyond 1 ms, to 2 ms"});
  Odd world(by);
  RefusedAsker asker;
  Thrower sensor(Thrower::Where::nowhere);
  runtime::Device* devices[] = {&sensor};
  const auto outcome = runtime::Dispatcher(devices, world).run(asker.skill);
  CHECK(outcome.reason == why);
  CHECK(sensor.closed);
}

TEST_CASE("nothing that the world throws leaves a run") {
  struct Breaking final : runtime::World {
    void advance_to(runtime::Time when) override {
      if (when > 0ms) throw "an earthquake";
    }
  } world;
  RefusedAsker asker;
  Thrower sensor(Thrower::Where::nowhere);
  runtime::Device* devices[] = {&sensor};
  const auto outcome = runtime::Dispatcher(devices, world).run(asker.skill);
  CHECK(outcome.fault);
  CHECK(outcome.reason == "the world: an exception that is not a std::exception");
  CHECK(sensor.closed);
}

TEST_CASE("a run that is begun inside a device is refused, and the outer one goes on") {
  RefusedAsker outer, inner;
  Thrower sensor(Thrower::Where::nowhere);
  NoWorld world;
  runtime::Device* devices[] = {&sensor};
  runtime::Dispatcher dispatcher(devices, world);
  runtime::Dispatcher another(devices, world);
  NoWorld elsewhere;
  runtime::Dispatcher third(devices, elsewhere);
  std::vector<std::string> reasons;
  sensor.on_receive = [&] {
    reasons.push_back(dispatcher.run(inner.skill).reason);
    reasons.push_back(another.run(outer.skill).reason);
    reasons.push_back(another.run(inner.skill).reason);
    reasons.push_back(third.run(inner.skill).reason);
    // Nor from another thread, in real time.
    std::thread([&] {
      reasons.push_back(another.run(inner.skill, {}, {.real_time = runtime::RealTime{}}).reason);
    }).join();
  };
  const auto outcome = dispatcher.run(outer.skill);
  CHECK_FALSE(outcome.fault);
  CHECK(outcome.code == 0);
  CHECK(reasons == std::vector<std::string>{"another skill is running; a dispatcher runs one at a time",
                                            "the skill is running already",
                                            "the world is in use by a skill that is running",
                                            "device sensor is in use by a skill that is running",
                                            "the world is in use by a skill that is running"});
  // Afterwards everything is free again.
  sensor.on_receive = nullptr;
  CHECK_FALSE(another.run(inner.skill).fault);
}

TEST_CASE("a stop before any event ends the skill there, with its devices closed") {
  // As many events as the run has: each place is tried.
  bool completed = false;
  int places = 0;
  for (int at = 0; !completed && at < 100; ++at, ++places) {
    struct Stopping final : runtime::World {
      void advance_to(runtime::Time) override {}
      runtime::Time next_event() override {  // asked once for each event
        if (left-- == 0) control.stop();
        return runtime::Time::max();
      }
      int left = 0;
      runtime::RunControl control;
    } world;
    world.left = at;
    RefusedAsker asker;
    Thrower sensor(Thrower::Where::nowhere);
    runtime::Device* devices[] = {&sensor};
    runtime::RunOptions options;
    options.control = &world.control;
    const auto outcome = runtime::Dispatcher(devices, world).run(asker.skill, {}, options);
    completed = !outcome.fault;
    if (!completed) CHECK(outcome.reason == "stopped on request");
    CHECK(sensor.closed);
  }
  CHECK(completed);
  CHECK(places > 3);
}

TEST_CASE("a thread without a body is an error of the skill, not a crash") {
  RefusedAsker asker;
  asker.skill.thread("B", 0, 1, [](Thread&) { return Task(); });
  Thrower sensor(Thrower::Where::nowhere);
  const auto outcome = run(asker.skill, {&sensor});
  CHECK(outcome.fault);
  CHECK(outcome.reason == "the skill has no body for its thread B");
}

TEST_CASE("whole numbers of messages are carried without loss, or refused") {
  constexpr std::int64_t most = runtime::greatest_whole;
  for (const std::int64_t value : {std::int64_t{0}, std::int64_t{-7}, most, -most, most - 1})
    CHECK(runtime::whole(runtime::from_whole(value)) == value);
  CHECK_THROWS_WITH(runtime::from_whole(most + 1),
                    "a message's INTEGER field is beyond 2^53, which a message cannot carry");
  CHECK_THROWS_AS(runtime::from_whole(-most - 1), std::out_of_range);
  for (const double bad : {std::nan(""), std::ldexp(1.0, 54), -1e300, HUGE_VAL, 0.5})
    CHECK_THROWS_AS(runtime::whole(bad), std::out_of_range);
}

TEST_CASE("a REAL of a message is finite and a BOOLEAN 0 or 1, or they are refused") {
  std::array<double, 1> numbers{};
  double real = 0;
  bool boolean = false;
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    CHECK_THROWS_WITH(runtime::put(bad, numbers, 0), "a message's REAL field is not a finite number");
    numbers[0] = bad;
    CHECK_THROWS_WITH(runtime::get(real, numbers, 0), "a message's REAL field is not a finite number");
    CHECK_THROWS_AS(runtime::get(boolean, numbers, 0), std::out_of_range);
  }
  for (const double bad : {0.5, 2.0, -1.0}) {
    numbers[0] = bad;
    CHECK_THROWS_WITH(runtime::get(boolean, numbers, 0), "a message's BOOLEAN field is neither 0 nor 1");
  }
  for (const bool value : {false, true}) {
    runtime::put(value, numbers, 0);
    runtime::get(boolean, numbers, 0);
    CHECK(boolean == value);
  }
  std::array<double, 3> many{0, 1e308, -5};
  runtime::put(many, std::span<double>(many), 0);
  runtime::get(many, std::span<const double>(many), 0);
  CHECK(many[1] == 1e308);
}
