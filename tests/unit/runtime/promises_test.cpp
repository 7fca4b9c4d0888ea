// Promises that are broken while a skill runs: of devices, of statements, of requirements; and what is done
// then.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "runtime/watch/device_watch.hpp"
#include "tests/run/support/allocation_count.hpp"
#include "tests/run/support/bench.hpp"
#include "tests/unit/runtime/one_index.hpp"

using namespace pal;
using namespace pal::test;
using runtime::BrokenPromise;
using runtime::DeviceHost;
using runtime::DeviceTimes;
using runtime::DeviceWatch;
using runtime::from;
using runtime::OnBrokenPromise;
using runtime::RequirementSpec;
using runtime::Seen;
using runtime::Task;
using runtime::Thread;
using runtime::Time;
using Behaviour = DeviceTimes::Behaviour;
using Measure = RequirementSpec::Measure;

namespace {

// A asks the sensor for x, three times. The sensor promises 2 to 3 ms, and takes what the test says.
struct PromisedAsker {
  PromisedAsker() {
    const int p = skill.processor("P");
    skill.devices = {"sensor"};
    skill.times = {{.behaviour = Behaviour::on_request, .answer = {2ms, 3ms}}};
    request = skill.channel("A", "request x", "sensor");
    skill.channels.back().to_device = true;
    x = skill.channel("sensor", "x", "A");
    skill.channels.back().from_device = true;
    skill.channels.front().answer = x;
    send = skill.statement("send");
    receive = skill.statement("receive", 100us);
    end = skill.statement("end");
    skill.requirements = {{.name = "fresh",
                           .measure = Measure::duration,
                           .channels = {},
                           .at = {},
                           .threads = only(0),
                           .devices = only(0)},
                          {.name = "elsewhere", .channels = {}, .at = {}, .threads = {}, .devices = {}}};
    skill.thread("A", p, 1, [this](Thread& t) -> Task {
      for (int i = 0; i < 3; ++i) {
        co_await t.send(send, request);
        co_await t.wait(receive, from(x));
      }
      co_await t.complete(end, 0);
    });
    sensor.on_receive = [this](DeviceHost& host, std::size_t, std::span<const double>) {
      if (answer_times.empty()) return;  // never
      host.at(host.now() + answer_times.front(), [&host] { host.deliver(1, {}); });
      answer_times.erase(answer_times.begin());
    };
  }
  runtime::Outcome go(OnBrokenPromise policy = OnBrokenPromise::report) {
    runtime::RunOptions options;
    options.on_broken_promise = policy;
    return run(skill, {&sensor}, options);
  }
  WrittenSkill skill;
  ScriptedDevice sensor{"sensor", {{"request x", true, {}}, {"x", false, {}}}};
  std::vector<Time> answer_times{2ms, 3ms, 2500us};
  int request = 0, x = 0, send = 0, receive = 0, end = 0;
};

}  // namespace

TEST_CASE("a device that keeps its promise to the nanosecond breaks none") {
  PromisedAsker asker;
  const auto outcome = asker.go(OnBrokenPromise::stop);
  CHECK(outcome.code == 0);
  CHECK(outcome.broken_promises.empty());
  CHECK(outcome.trace.promises.empty());
}

TEST_CASE(
    "an answer that comes late is noted when it is due, with what it endangers, and the skill goes on") {
  PromisedAsker asker;
  asker.answer_times = {3ms, 400ms, 5ms};
  const auto outcome = asker.go();
  CHECK(outcome.code == 0);
  CHECK_FALSE(outcome.fault);
  REQUIRE(outcome.broken_promises.size() == 1);
  const BrokenPromise& broken = outcome.broken_promises.front();
  CHECK(broken.promise == "sensor answers 3 ms after a request at the latest");
  CHECK(broken.by == "sensor");
  CHECK(broken.measured == 400ms);
  CHECK(broken.first == 6100us + 1ns);
  CHECK(broken.times == 2);
  CHECK(broken.endangers == std::vector<std::string>{"fresh"});
  CHECK(in_words(broken) ==
        "sensor answers 3 ms after a request at the latest: measured 400 ms, 2 times; endangers fresh");
  CHECK(outcome.trace.promises == std::vector<std::string>{broken.promise});
  CHECK(only(to_text(outcome.trace), {"broken"}) ==
        "6.1 broken sensor: sensor answers 3 ms after a request at the latest\n"
        "406.2 broken sensor: sensor answers 3 ms after a request at the latest\n");
}

TEST_CASE("an answer that comes too soon is another promise") {
  PromisedAsker asker;
  asker.answer_times = {2ms - 1ns, 3ms, 3ms + 1ns};
  const auto outcome = asker.go();
  REQUIRE(outcome.broken_promises.size() == 2);
  CHECK(outcome.broken_promises[0].promise == "sensor answers 2 ms after a request at the soonest");
  CHECK(outcome.broken_promises[0].measured == 2ms - 1ns);
  CHECK(outcome.broken_promises[1].measured == 3ms + 1ns);
}

TEST_CASE(
    "policy stop: the skill ends with its error completion when the promise is broken, devices closed") {
  PromisedAsker asker;
  asker.answer_times = {3ms, 400ms, 5ms};
  const auto outcome = asker.go(OnBrokenPromise::stop);
  CHECK(outcome.fault);
  CHECK(outcome.code == 9);
  CHECK(outcome.duration == 6100us + 1ns);
  CHECK(outcome.reason ==
        "sensor answers 3 ms after a request at the latest: measured 3.000001 ms; endangers fresh");
  CHECK(outcome.broken_promises.size() == 1);
  CHECK(asker.sensor.closed == 1);
}

TEST_CASE("a device that never answers is noted when its time is over") {
  PromisedAsker asker;
  asker.answer_times.clear();
  const auto outcome = asker.go();
  CHECK(outcome.fault);
  CHECK(outcome.reason.find("nothing is left to happen") == 0);
  CHECK(outcome.duration == 3ms + 1ns);
  REQUIRE(outcome.broken_promises.size() == 1);
}

TEST_CASE("policy contingency: the skill is told once, and leads itself to its contingency") {
  PromisedAsker asker;
  asker.answer_times = {2ms, 400ms, 2ms, 2ms};
  bool broken = false;
  std::vector<std::string> told;
  asker.skill.on_promise_broken = [&](const BrokenPromise& promise) {
    told.push_back(promise.promise);
    broken = true;
    return true;
  };
  const int c = asker.skill.condition("pc-broken");
  const int set = asker.skill.statement("SPC( pc-broken )");
  asker.skill.bodies.front() = [&, c, set](Thread& t) -> Task {
    for (;;) {
      co_await t.send(asker.send, asker.request);
      co_await t.wait(asker.receive, from(asker.x));
      co_await t.set(set, c, [&] { return broken; });
      co_await t.test(set, c);
      if (t.tested(c)) break;
    }
    co_await t.complete(asker.end, 1);
  };
  const auto outcome = asker.go(OnBrokenPromise::contingency);
  CHECK_FALSE(outcome.fault);
  CHECK(outcome.code == 1);
  CHECK(told == std::vector<std::string>{"sensor answers 3 ms after a request at the latest"});
}

TEST_CASE("policy contingency: a skill that has no answer, or throws, is stopped") {
  PromisedAsker asker;
  asker.answer_times = {5ms, 5ms, 5ms};
  std::string why;
  SECTION("none") {
    why = "; the skill has no answer to it";
  }
  SECTION("throws") {
    asker.skill.on_promise_broken = [](const BrokenPromise&) -> bool { throw std::runtime_error("no idea"); };
    why = "; the skill's answer: no idea";
  }
  const auto outcome = asker.go(OnBrokenPromise::contingency);
  CHECK(outcome.fault);
  CHECK(outcome.code == 9);
  CHECK(outcome.reason.ends_with(why));
}

TEST_CASE("a statement that takes longer than its worst is noted with its line") {
  PromisedAsker asker;
  runtime::RunOptions options;
  options.slow = {{"M", 2, 40ms, 3ms}};  // the second line: receive
  const auto outcome = run(asker.skill, {&asker.sensor}, options);
  CHECK(outcome.code == 0);
  REQUIRE(outcome.broken_promises.size() == 1);
  const BrokenPromise& broken = outcome.broken_promises.front();
  CHECK(broken.promise == "receive of M (written.pal:2) takes at most 100 us");
  CHECK(broken.by == "A");
  CHECK(broken.measured == 40ms);
  CHECK(broken.times == 2);
  CHECK(broken.endangers == std::vector<std::string>{"fresh"});

  options.on_broken_promise = OnBrokenPromise::stop;
  asker.answer_times = {2ms, 3ms, 2500us};
  const auto stopped = run(asker.skill, {&asker.sensor}, options);
  CHECK(stopped.fault);
  CHECK(stopped.reason.find("receive of M (written.pal:2) takes at most 100 us: measured 40 ms") == 0);
}

// Whether each instant of the events keeps the promise.
std::vector<Seen::What> events(const DeviceTimes& times, const std::vector<Time>& instants) {
  DeviceWatch watch(times);
  watch.opened(0ms);
  std::vector<Seen::What> result;
  for (const Time instant : instants) result.push_back(watch.event(instant).what);
  return result;
}

TEST_CASE("events of a device: neither closer than their period nor later, jitter allowed for") {
  const auto kept = Seen::What::kept, sooner = Seen::What::sooner, later = Seen::What::later;
  const DeviceTimes exact{Behaviour::events, "tick", 28ms};
  CHECK(events(exact, {28ms, 56ms, 84ms}) == std::vector{kept, kept, kept});
  CHECK(events(exact, {29ms}) == std::vector{later});
  CHECK(events(exact, {0ms, 20ms, 48ms}) == std::vector{kept, sooner, kept});
  CHECK(events(exact, {0ms, 30ms, 58ms}) == std::vector{kept, later, kept});
  const DeviceTimes jitter{Behaviour::events, "tick", 10ms, 2ms};
  CHECK(events(jitter, {2ms, 10ms, 22ms, 30ms}) == std::vector{kept, kept, kept, kept});
  CHECK(events(jitter, {2ms, 10ms, 18ms}) ==
        std::vector{kept, kept, sooner});  // each 8 ms apart: not for long
  CHECK(events(jitter, {2ms, 15ms}) == std::vector{kept, later});
  const DeviceTimes sporadic{Behaviour::sporadic, "tick", 10ms, 2ms};
  CHECK(events(sporadic, {500ms, 508ms, 515ms, 3s}) == std::vector{kept, kept, sooner, kept});
  const DeviceTimes phase{Behaviour::events, "tick", 28ms, 0ms, 5ms};
  CHECK(events(phase, {5ms, 33ms}) == std::vector{kept, kept});
  CHECK(events(phase, {4ms}) == std::vector{sooner});
}

// The events of a minute after the first wait, by a clock that is wrong by up to 50 ppm: always by the share
// that `share` gives, -1 to 1, for the number of the event.
template <class Share>
std::vector<Time> drifting(Share share) {
  const double period = 28e6, most = 50e-6;
  std::vector<Time> result;
  // The last instant for a first event, or the first one.
  double at = share(0) > 0 ? period * (1 + most) : 0;
  for (int number = 1; at < 60e9; ++number) {
    result.emplace_back(static_cast<std::int64_t>(at));
    at += period * (1 + most * share(number));
  }
  return result;
}

TEST_CASE("a clock that drifts is a shorter period with a jitter of twice the drift of the longest run") {
  const DeviceTimes allowed{Behaviour::events, "tick", 27'998'600ns, 6ms};
  const DeviceTimes sporadic{Behaviour::sporadic, "tick", 27'998'600ns};
  const DeviceTimes exact{Behaviour::events, "tick", 28ms};
  const auto broken = [](const DeviceTimes& times, const std::vector<Time>& instants) {
    const auto seen = events(times, instants);
    return std::count_if(seen.begin(), seen.end(), [](Seen::What what) { return what != Seen::What::kept; });
  };
  for (const auto& share : {+[](int) { return 1.0; }, +[](int) { return -1.0; },
                            +[](int number) { return number < 1000 ? 1.0 : -1.0; },
                            +[](int number) { return number < 1000 ? -1.0 : 1.0; },
                            +[](int number) { return std::sin(number / 100.0); }}) {
    const std::vector<Time> instants = drifting(share);
    REQUIRE(instants.size() > 2100);
    CHECK(broken(allowed, instants) == 0);
    CHECK(broken(sporadic, instants) == 0);
    CHECK(broken(exact, instants) > 0);
  }
  // No less will do for a clock that is slow for the whole minute.
  const DeviceTimes less{Behaviour::events, "tick", 27'998'600ns, 5900us};
  CHECK(broken(less, drifting([](int) { return 1.0; })) > 0);
}

TEST_CASE("a device that serves one request at a time has its time for each") {
  DeviceWatch watch({.behaviour = Behaviour::on_request, .answer = {2ms, 3ms}});
  watch.asked(0ms);
  watch.asked(1ms);
  CHECK(watch.due() == 3ms + 1ns);
  CHECK(watch.answered(3ms, 0ms).what == Seen::What::kept);
  CHECK(watch.due() == 6ms + 1ns);
  CHECK(watch.answered(6ms, 1ms).what == Seen::What::kept);
  CHECK(watch.due() == Time::max());
  watch.asked(10ms);
  watch.forgotten(11ms, false);
  CHECK(watch.due() == Time::max());
}

TEST_CASE("a frame comes at most a period and its collection after the request") {
  DeviceWatch watch({.behaviour = Behaviour::frames, .period = 78ms, .answer = {76ms, 76ms}});
  watch.asked(0ms);
  CHECK(watch.due() == 154ms + 1ns);
  CHECK(watch.answered(154ms, 0ms).what == Seen::What::kept);
  watch.asked(160ms);
  CHECK(watch.answered(200ms, 160ms).what == Seen::What::sooner);
  watch.asked(300ms);
  const Seen late = watch.overdue(300ms + 154ms + 1ns);
  CHECK(late.what == Seen::What::later);
  CHECK(watch.due() == Time::max());
  CHECK(watch.answered(700ms, 300ms).noted);
}

TEST_CASE("a promise and a requirement that are broken again and again allocate for the first time only") {
  WrittenSkill skill;
  const int p = skill.processor("P");
  skill.devices = {"sensor"};
  skill.times = {{.behaviour = Behaviour::on_request, .answer = {2ms, 3ms}}};
  const int request = skill.channel("A", "request x", "sensor");
  skill.channels.back().to_device = true;
  const int x = skill.channel("sensor", "x", "A");
  skill.channels.back().from_device = true;
  skill.channels.front().answer = x;
  const int act = skill.statement("act", 10us), send = skill.statement("send"),
            receive = skill.statement("receive", 100us), end = skill.statement("end");
  const int sends[] = {send};
  runtime::RequirementSpec& often = skill.requirements.emplace_back();
  often.name = "often";
  often.measure = Measure::interval;
  often.most = 1ms;
  often.at = sends;
  skill.thread("A", p, 1, [&](Thread& t) -> Task {
    for (int i = 0; i < 40; ++i) {
      co_await t.perform(act, [i] {
        if (i == 3) {
          reset_allocations();
          count_allocations(true);
        }
        if (i == 39) count_allocations(false);
      });
      co_await t.send(send, request);
      co_await t.wait(receive, from(x));
    }
    co_await t.complete(end, 0);
  });
  ScriptedDevice sensor("sensor", {{"request x", true, {}}, {"x", false, {}}});
  sensor.on_receive = [](DeviceHost& host, std::size_t, std::span<const double>) {
    host.at(host.now() + 5ms, [&host] { host.deliver(1, {}); });  // 2 ms late
  };
  const auto outcome = run(skill, {&sensor});
  CHECK(outcome.code == 0);
  REQUIRE(outcome.broken_promises.size() == 2);
  CHECK(outcome.broken_promises[0].times == 40);
  CHECK(outcome.broken_promises[1].times == 39);
  CHECK(counted_allocations() == 0);
}
