// Requirements that are broken while a skill runs, and events that come too soon or not at all.
#include <catch2/catch.hpp>

#include "tests/run/support/bench.hpp"
#include "tests/unit/runtime/one_index.hpp"

using namespace pal;
using namespace pal::test;
using runtime::DeviceHost;
using runtime::DeviceTimes;
using runtime::from;
using runtime::OnBrokenPromise;
using runtime::RequirementSpec;
using runtime::Task;
using runtime::Thread;
using runtime::Time;
using Behaviour = DeviceTimes::Behaviour;
using Measure = RequirementSpec::Measure;

namespace {

// A bell rings every 10 ms. A hears it, works, sets c, reads it and rings back.
struct Bell {
  Bell() {
    const int p = skill.processor("P");
    skill.devices = {"bell"};
    skill.times = {{Behaviour::events, "ring", 10ms}};
    ring = skill.channel("bell", "ring", "A");
    skill.channels.back().from_device = true;
    back = skill.channel("A", "back", "bell");
    skill.channels.back().to_device = true;
    c = skill.condition("c");
    hear = skill.statement("hear");
    answer = skill.statement("answer", 1ms);
    act = skill.statement("act", 1ms);
    set = skill.statement("set");
    skill.thread("A", p, 1, [this](Thread& t) -> Task {
      for (const int naps : work) {
        co_await t.wait(hear, from(ring));
        co_await t.set(set, c, true);
        co_await t.read(set, c);
        for (int i = 0; i < naps; ++i) co_await t.perform(act, [] {});
        co_await t.send(answer, back);
      }
      co_await t.complete(act, 0);
    });
    bell.on_open = [](DeviceHost& host) {
      for (int i = 1; i < 10; ++i) host.at(host.now() + i * 10ms, [&host] { host.deliver(0, {}); });
    };
  }
  runtime::Outcome require(RequirementSpec spec, OnBrokenPromise policy = OnBrokenPromise::report) {
    spec.name = "r";
    skill.requirements = {spec};
    runtime::RunOptions options;
    options.on_broken_promise = policy;
    options.trace = runtime::TraceMode::none;  // what is measured needs no trace
    return run(skill, {&bell}, options);
  }
  WrittenSkill skill;
  ScriptedDevice bell{"bell", {{"ring", false, {}}, {"back", true, {}}}};
  std::vector<int> work{1, 3, 1};
  int ring = 0, back = 0, c = 0, hear = 0, answer = 0, act = 0, set = 0;
};

RequirementSpec spec(Measure measure, int channel, int at) {
  RequirementSpec result;
  result.measure = measure;
  if (channel >= 0) result.channels = only(channel);
  result.at = only(at);
  return result;
}

}  // namespace

TEST_CASE("a late response is seen when its limit is over, not when it comes") {
  Bell bell;
  RequirementSpec response = spec(Measure::response, 0, 1);
  response.most = 4ms;
  CHECK(bell.require(response).broken_promises.empty());
  response.most = 3ms;
  auto outcome = bell.require(response);
  REQUIRE(outcome.broken_promises.size() == 1);
  CHECK(outcome.broken_promises[0].promise == "requirement r, a response of at most 3 ms");
  CHECK(outcome.broken_promises[0].measured == 4ms);
  CHECK(outcome.broken_promises[0].times == 1);
  CHECK(outcome.broken_promises[0].first == 23ms + 1ns);
  CHECK(outcome.broken_promises[0].endangers == std::vector<std::string>{"r"});
  outcome = bell.require(response, OnBrokenPromise::stop);
  CHECK(outcome.fault);
  CHECK(outcome.duration == 23ms + 1ns);
}

TEST_CASE("an event that is lost fails its response, whatever its limit") {
  Bell bell;
  bell.work = {30, 1};
  RequirementSpec response = spec(Measure::response, 0, 1);
  response.most = 1s;
  const auto outcome = bell.require(response);
  CHECK(outcome.overruns == 2);
  REQUIRE(outcome.broken_promises.size() == 1);
  CHECK(outcome.broken_promises[0].measured == Time::max());
  CHECK(in_words(outcome.broken_promises[0]) ==
        "requirement r, a response of at most 1 s: not answered, 2 times; endangers r");
}

TEST_CASE("ages, samples, intervals and durations are measured while the skill runs") {
  Bell bell;
  RequirementSpec age = spec(Measure::age, -1, 1);
  age.condition = 0;
  RequirementSpec sample = spec(Measure::sample, 0, 1);
  RequirementSpec interval = spec(Measure::interval, -1, 1);
  RequirementSpec duration = spec(Measure::duration, -1, 1);
  struct Case {
    RequirementSpec spec;
    Time most;
  };
  // The second of three answers comes 4 ms after its ring, the others 2 ms: so they are 12 and 8 ms apart.
  for (const Case& each : {Case{age, 4ms}, Case{sample, 4ms}, Case{interval, 12ms}, Case{duration, 33ms}}) {
    CAPTURE(static_cast<int>(each.spec.measure));
    RequirementSpec limited = each.spec;
    limited.most = each.most;
    CHECK(bell.require(limited).broken_promises.empty());
    limited.most = each.most - 1ns;
    const auto outcome = bell.require(limited);
    REQUIRE(outcome.broken_promises.size() == 1);
    CHECK(outcome.broken_promises[0].measured == each.most);
    CHECK(bell.require(limited, OnBrokenPromise::stop).code == 9);
  }
  interval.least = 8ms;
  CHECK(bell.require(interval).broken_promises.empty());
  interval.least = 8ms + 1ns;
  const auto outcome = bell.require(interval);
  REQUIRE(outcome.broken_promises.size() == 1);
  CHECK(outcome.broken_promises[0].promise == "requirement r, an interval of at least 8.000001 ms");
  CHECK(outcome.broken_promises[0].measured == 8ms);
}

TEST_CASE("a bell that rings too soon, or falls silent, is noted") {
  Bell bell;
  Time step = 10ms;
  int rings = 5;
  bell.bell.on_open = [&](DeviceHost& host) {
    for (int i = 1; i <= rings; ++i) host.at(host.now() + i * step, [&host] { host.deliver(0, {}); });
  };
  SECTION("too soon") {
    step = 9ms;
    const auto outcome = run(bell.skill, {&bell.bell});
    REQUIRE(outcome.broken_promises.size() == 1);
    CHECK(in_words(outcome.broken_promises[0]) ==
          "bell sends ring every 10 ms, not sooner: measured 9 ms, 2 times");
  }
  SECTION("silent") {
    rings = 1;
    const auto outcome = run(bell.skill, {&bell.bell});
    REQUIRE(outcome.broken_promises.size() == 1);
    CHECK(outcome.broken_promises[0].promise == "bell sends ring every 10 ms, not later");
    CHECK(outcome.broken_promises[0].first == 20ms + 1ns);
  }
}
