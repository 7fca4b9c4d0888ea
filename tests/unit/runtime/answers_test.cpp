// Which request a device's answer answers: answers that are lost, late, too many, or left out.
#include <catch2/catch.hpp>
#include <set>

#include "tests/run/support/bench.hpp"
#include "tests/unit/runtime/one_index.hpp"

using namespace pal;
using namespace pal::test;
using runtime::DeviceHost;
using runtime::DeviceTimes;
using runtime::from;
using runtime::OnBrokenPromise;
using runtime::Task;
using runtime::Thread;
using runtime::Time;

namespace {

// A asks the sensor for x five times, 6 ms after it has heard or given up, which it does after 4 ms. The
// sensor promises 2 to 3 ms.
struct Asker {
  Asker() {
    const int p = skill.processor("P");
    skill.devices = {"sensor"};
    skill.times = {{.behaviour = DeviceTimes::Behaviour::on_request, .answer = {2ms, 3ms}}};
    request = skill.channel("A", "request x", "sensor");
    skill.channels.back().to_device = true;
    x = skill.channel("sensor", "x", "A");
    skill.channels.back().from_device = true;
    skill.channels.front().answer = x;
    never = skill.channel("nobody", "never", "A");
    send = skill.statement("send");
    receive = skill.statement("receive");
    rest = skill.statement("rest", 0ms);
    end = skill.statement("end");
    skill.thread("A", p, 1, [this](Thread& t) -> Task {
      for (int i = 0; i < 5; ++i) {
        co_await t.send(send, request);
        heard.push_back(co_await t.wait_within(receive, 4ms, from(x)) == 0);
        co_await t.wait_within(rest, 6ms, from(never));
      }
      co_await t.complete(end, 0);
    });
    sensor.on_receive = [this](DeviceHost& host, std::size_t, std::span<const double>) {
      requests.push_back(host.request());
      if (does) does(host, requests.size());
    };
  }
  /// The sensor answers after `delay`.
  static void answer(DeviceHost& host, Time delay = 2500us) {
    host.at(host.now() + delay, [&host] { host.deliver(1, {}); });
  }
  runtime::Outcome go(OnBrokenPromise policy = OnBrokenPromise::report) {
    runtime::RunOptions options;
    options.on_broken_promise = policy;
    return run(skill, {&sensor}, options);
  }

  WrittenSkill skill;
  ScriptedDevice sensor{"sensor", {{"request x", true, {}}, {"x", false, {}}}};
  std::function<void(DeviceHost&, std::size_t)> does;  // at the so manieth request
  std::vector<DeviceHost::Request> requests;
  std::vector<bool> heard;
  int request = 0, x = 0, never = 0, send = 0, receive = 0, rest = 0, end = 0;
};

const std::string once = "sensor answers each request once, and nothing else";

/// "2 x sensor answers …"
std::vector<std::string> broken(const runtime::Outcome& outcome) {
  std::vector<std::string> result;
  for (const auto& each : outcome.broken_promises)
    result.push_back(std::to_string(each.times) + " x " + each.promise);
  return result;
}

}  // namespace

TEST_CASE("OR NEVER: a request without an answer is open no more, is no broken promise, and costs no other") {
  Asker asker;
  asker.skill.times.front().may_fail = true;
  const bool marks = GENERATE(false, true);
  asker.does = [marks](DeviceHost& host, std::size_t nth) {
    if (marks) host.mark_busy(true);
    if (nth != 2 && nth != 3) Asker::answer(host);
    if (marks) host.at(host.now() + 2500us, [&host] { host.mark_busy(false); });
  };
  const auto outcome = asker.go(OnBrokenPromise::stop);
  CAPTURE(outcome.reason);
  CHECK_FALSE(outcome.fault);
  CHECK(asker.heard == std::vector{true, false, false, true, true});
  CHECK(outcome.broken_promises.empty());
  // It is open for as long as an answer may come.
  CHECK(only(to_text(outcome.trace), {"drop sensor"}) == "11.5 drop sensor <x>\n21.5 drop sensor <x>\n");
}

TEST_CASE("OR NEVER: a plain wait goes on, and hears the answer to the next request") {
  Asker asker;
  asker.skill.times.front().may_fail = true;
  const int p = 0;
  asker.skill.thread("B", p, 2, [&](Thread& t) -> Task {
    co_await t.wait_within(asker.rest, 7ms, from(asker.never));
    co_await t.send(asker.send, asker.request);
  });
  asker.skill.bodies.front() = [&](Thread& t) -> Task {
    co_await t.send(asker.send, asker.request);
    asker.heard.push_back(co_await t.wait(asker.receive, from(asker.x)) == 0);
    co_await t.complete(asker.end, 0);
  };
  asker.does = [](DeviceHost& host, std::size_t nth) {
    if (nth == 2) Asker::answer(host);
  };
  const auto outcome = asker.go(OnBrokenPromise::stop);
  CAPTURE(outcome.reason);
  CHECK_FALSE(outcome.fault);
  CHECK(asker.heard == std::vector{true});
  CHECK(outcome.duration == 9500us);
}

TEST_CASE("OR NEVER: an answer after its time is noted, and is not taken for that to the next request") {
  Asker asker;
  asker.skill.times.front().may_fail = true;
  asker.does = [](DeviceHost& host, std::size_t nth) { Asker::answer(host, nth == 2 ? 11ms : 2500us); };
  const auto outcome = asker.go();
  CHECK(asker.heard == std::vector{true, false, true, true, true});
  CHECK(broken(outcome) == std::vector{"1 x " + once});
  CHECK(only(to_text(outcome.trace), {"take A"}) ==
        "2.5 take A receive <x>\n21 take A receive <x>\n29.5 take A receive <x>\n38 take A receive <x>\n");
}

TEST_CASE("an answer that is lost costs one answer") {
  Asker asker;
  const bool marks = GENERATE(false, true);
  asker.does = [marks](DeviceHost& host, std::size_t nth) {
    if (marks) host.mark_busy(true);
    if (nth != 2) Asker::answer(host);
    if (marks) host.at(host.now() + 2500us, [&host] { host.mark_busy(false); });
  };
  const auto outcome = asker.go();
  CHECK_FALSE(outcome.fault);
  CHECK(asker.heard == std::vector{true, false, true, true, true});
  CHECK(broken(outcome) == std::vector<std::string>{"1 x sensor answers 3 ms after a request at the latest"});
}

TEST_CASE("an answer that nobody asked for, or a second one, is noted and shifts nothing") {
  Asker asker;
  asker.does = [](DeviceHost& host, std::size_t nth) {
    Asker::answer(host);
    if (nth == 1) Asker::answer(host, 5ms);
    if (nth == 2) Asker::answer(host, 2600us);
  };
  const auto outcome = asker.go();
  CHECK(asker.heard == std::vector{true, true, true, true, true});
  CHECK(broken(outcome) == std::vector{"2 x " + once});
  CHECK(only(to_text(outcome.trace), {"take A"}) ==
        "2.5 take A receive <x>\n11 take A receive <x>\n19.5 take A receive <x>\n28 take A receive <x>\n36.5 "
        "take A receive <x>\n");
  CHECK(in_words(outcome.broken_promises.front()) == once + ", 2 times");

  Asker stopped;
  stopped.does = asker.does;
  const auto end = stopped.go(OnBrokenPromise::stop);
  CHECK(end.fault);
  CHECK(end.reason == once);
}

TEST_CASE("an answer says which request it answers") {
  Asker asker;
  asker.does = [&asker](DeviceHost& host, std::size_t nth) {
    const DeviceHost::Request mine = asker.requests.back();
    // The second answer comes after the third request, when that could be answered already.
    host.at(host.now() + (nth == 2 ? 12100us : 2500us), [&host, mine] { host.answer(mine, 1, {}); });
  };
  const auto outcome = asker.go();
  CHECK(asker.heard == std::vector{true, false, true, true, true});
  CHECK(only(to_text(outcome.trace), {"take A"}) ==
        "2.5 take A receive <x>\n21 take A receive <x>\n29.5 take A receive <x>\n38 take A receive <x>\n");
  CHECK(asker.requests.size() == 5);
  CHECK(std::set<DeviceHost::Request>(asker.requests.begin(), asker.requests.end()).size() == 5);
  CHECK(asker.requests.front() != 0);
}

TEST_CASE("a device says that a request has no answer") {
  Asker asker;
  asker.does = [](DeviceHost& host, std::size_t nth) {
    if (nth == 2) return host.leave_unanswered(1);
    Asker::answer(host);
  };
  const bool may = GENERATE(false, true);
  asker.skill.times.front().may_fail = may;
  const auto outcome = asker.go();
  CHECK(asker.heard == std::vector{true, false, true, true, true});
  CHECK(broken(outcome) == (may ? std::vector<std::string>{} : std::vector{"1 x " + once}));
  CHECK(only(to_text(outcome.trace), {"drop sensor"}) == "8.5 drop sensor <x>\n");
}

TEST_CASE("devices without declared times: what nobody asked for is noted and lost all the same") {
  Asker asker;
  asker.skill.times.clear();
  asker.does = [](DeviceHost& host, std::size_t nth) {
    Asker::answer(host);
    if (nth == 1) Asker::answer(host, 5ms);
  };
  const auto outcome = asker.go();
  CHECK(asker.heard == std::vector{true, true, true, true, true});
  CHECK(broken(outcome) == std::vector{"1 x " + once});
}
