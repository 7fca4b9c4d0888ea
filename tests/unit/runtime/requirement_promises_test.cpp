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
      std::size_t turn = 0;
      for (const int naps : work) {
        std::optional<Thread::Within> loop;
        if (turn++ < turns_in_loop) loop.emplace(t, 0);
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
  std::size_t turns_in_loop = 0;
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

TEST_CASE("reactions, losses, loads and busy periods are measured while the skill runs") {
  Bell bell;
  RequirementSpec reaction = spec(Measure::reaction, -1, 1);
  reaction.condition = 0;
  const RequirementSpec sample_reaction = spec(Measure::sample_reaction, 0, 1);
  RequirementSpec busy = spec(Measure::busy, -1, 1);
  busy.processors = only(0);
  struct Case {
    RequirementSpec spec;
    Time worst;
    const char* words;
  };
  // It answers at 12, 24 and 32 ms what was set, and rung, at 10, 20 and 30 ms.
  for (const Case& each : {Case{reaction, 14ms, "a reaction of at most 13.999999 ms"},
                           Case{sample_reaction, 14ms, "a reaction of at most 13.999999 ms"},
                           Case{busy, 4ms, "a busy period of at most 3.999999 ms"}}) {
    RequirementSpec limited = each.spec;
    limited.most = each.worst;
    auto outcome = bell.require(limited);
    CHECK(outcome.broken_promises.empty());
    REQUIRE(outcome.requirements.size() == 1);
    CHECK(outcome.requirements[0].worst == each.worst);
    limited.most = each.worst - 1ns;
    outcome = bell.require(limited);
    REQUIRE(outcome.broken_promises.size() == 1);
    CHECK(outcome.broken_promises[0].promise == std::string("requirement r, ") + each.words);
    CHECK(outcome.broken_promises[0].measured == each.worst);
    CHECK(outcome.broken_promises[0].times == 1);
    CHECK(bell.require(limited, OnBrokenPromise::stop).code == 9);
  }
}

TEST_CASE("a busy period is noted while it goes on") {
  Bell bell;
  bell.work = {30};
  RequirementSpec busy = spec(Measure::busy, -1, 1);
  busy.processors = only(0);
  busy.most = 5ms;
  const auto outcome = bell.require(busy);
  REQUIRE(outcome.broken_promises.size() == 1);
  CHECK(outcome.broken_promises[0].first == 15ms + 1ns);
  CHECK(outcome.broken_promises[0].times == 1);
  CHECK(outcome.broken_promises[0].measured == 32ms);
}

TEST_CASE("a busy period that a fault ends counts until then") {
  Bell bell;
  bell.work = {30};
  RequirementSpec busy = spec(Measure::busy, -1, 1);
  busy.processors = only(0);
  busy.most = 20ms;
  const auto outcome = bell.require(busy, OnBrokenPromise::stop);
  CHECK(outcome.fault);
  CHECK(outcome.requirements[0].worst == 20ms + 1ns);
}

TEST_CASE("losses are counted while the skill runs") {
  Bell bell;
  bell.work = {30, 1};  // the rings at 30 and 40 ms find their slot full
  RequirementSpec loss = spec(Measure::loss, -1, 1);
  loss.device = 0;
  loss.in = 2;
  loss.most = Time(2);
  CHECK(bell.require(loss).broken_promises.empty());
  loss.most = Time(1);
  auto outcome = bell.require(loss);
  REQUIRE(outcome.broken_promises.size() == 1);
  CHECK(in_words(outcome.broken_promises[0]) ==
        "requirement r, a loss of at most 1 in 2: measured 2; endangers r");
  loss.in = 1;
  outcome = bell.require(loss);
  CHECK(outcome.broken_promises.empty());
  CHECK(outcome.requirements[0].worst == Time(1));
}

TEST_CASE("a load is noted once it is beyond what its limit and a start allow") {
  Bell bell;
  RequirementSpec load = spec(Measure::load, -1, 1);
  load.processors = only(0);
  load.most = 200ms;  // of work in a second
  auto outcome = bell.require(load);
  CHECK(outcome.broken_promises.empty());
  CHECK(outcome.requirements[0].worst == Time(9'000'000LL * 1'000'000'000 / 33'000'000));
  load.most = 100ms;
  outcome = bell.require(load);
  REQUIRE(outcome.broken_promises.size() == 1);
  CHECK(in_words(outcome.broken_promises[0]) ==
        "requirement r, a load of at most 10 %: measured 25 %, 2 times; endangers r");
  CHECK(outcome.broken_promises[0].first == 24ms);  // and again at 31 ms; it was within it at 30 ms
}

TEST_CASE("a phase limits what is measured while the skill runs") {
  Bell bell;
  const auto worst = [&bell](RequirementSpec spec) { return bell.require(spec).requirements[0].worst; };
  RequirementSpec age = spec(Measure::age, -1, 1);
  age.condition = 0;
  RequirementSpec response = spec(Measure::response, 0, 1);
  RequirementSpec interval = spec(Measure::interval, -1, 1);
  RequirementSpec duration = spec(Measure::duration, -1, 1);
  RequirementSpec reaction = spec(Measure::reaction, -1, 1);
  reaction.condition = 0;
  SECTION("after the first answer") {
    for (RequirementSpec* each : {&age, &response, &interval, &duration, &reaction}) each->after = only(1);
    CHECK(worst(age) == 4ms);
    CHECK(worst(response) == 4ms);
    CHECK(worst(interval) == 8ms);
    CHECK(worst(duration) == 21ms);
    CHECK(worst(reaction) == 12ms);  // from 12 and from 20 ms on
  }
  SECTION("during the first turn") {
    bell.turns_in_loop = 1;
    for (RequirementSpec* each : {&age, &response, &interval, &reaction}) each->during = only(0);
    CHECK(worst(age) == 2ms);
    CHECK(worst(response) == 2ms);
    CHECK(worst(interval) == std::nullopt);
    CHECK(worst(reaction) == 12ms);
  }
  SECTION("two turns that follow one another are one phase") {
    bell.turns_in_loop = 2;
    for (RequirementSpec* each : {&age, &response, &interval, &reaction}) each->during = only(0);
    CHECK(worst(age) == 4ms);
    CHECK(worst(response) == 4ms);
    CHECK(worst(interval) == 12ms);
    CHECK(worst(reaction) == 14ms);
  }
}

TEST_CASE("how near a run comes to its requirements is there for others while it goes on") {
  Bell bell;
  RequirementSpec age = spec(Measure::age, -1, 1);
  age.condition = 0;
  age.name = "r";
  bell.skill.requirements = {age};
  runtime::Margins margins(1);
  CHECK_FALSE(margins.worst(0));
  runtime::RunOptions options;
  options.margins = &margins;
  run(bell.skill, {&bell.bell}, options);
  CHECK(margins.worst(0) == 4ms);
}

TEST_CASE("what a module keeps brings its sample to a block that did not take it") {
  Bell bell;
  const std::array kept{runtime::KeptSpec{runtime::KeptSpec::How::taken, 0, 0},
                        runtime::KeptSpec{runtime::KeptSpec::How::used, 2, 0}};
  const int p = bell.skill.processor("Q");
  const int nap = bell.skill.statement("nap", 25ms);
  bell.skill.thread("B", p, 1, [&bell, nap](Thread& t) -> Task {
    co_await t.perform(nap, [] {});
    co_await t.perform(bell.act, [] {});  // uses the ring of 20 ms, at 26 ms
  });
  RequirementSpec sample = spec(Measure::sample, 0, 2);
  sample.channels = only(0);
  CHECK(bell.require(sample).requirements[0].worst == 3ms);
  bell.skill.kept.assign(kept.begin(), kept.end());
  CHECK(bell.require(sample).requirements[0].worst == 6ms);
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
