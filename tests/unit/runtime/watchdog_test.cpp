// Code that does not return, and what the system does not permit: in processes of their own.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>

#include "tests/run/support/bench.hpp"

using namespace pal;
using namespace pal::test;
using runtime::from;
using runtime::RunOptions;
using runtime::Task;
using runtime::Thread;

namespace {

struct Ended {
  int status = -1;   // of exit; -1: by a signal
  std::string said;  // on standard error
};

/// Does `body` in a child, which ends with 0 if nothing ends it before.
Ended in_a_child(const std::function<void()>& body) {
  std::array<int, 2> ends{};
  REQUIRE(::pipe(ends.data()) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::dup2(ends[1], STDERR_FILENO);
    ::close(ends[0]);
    body();
    ::_exit(0);
  }
  ::close(ends[1]);
  Ended result;
  std::array<char, 256> buffer{};
  for (ssize_t count = 0; (count = ::read(ends[0], buffer.data(), buffer.size())) > 0;)
    result.said.append(buffer.data(), static_cast<std::size_t>(count));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
  return result;
}

void say(const std::string& text) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

// Says when it is closed.
struct Telling final : ScriptedDevice {
  Telling() : ScriptedDevice("sensor", {{"command", true, {}}}) {}
  void close() override {
    say("sensor closed\n");
    if (stuck)
      for (;;) ::pause();
  }
  bool stuck = false;
};

// A sends a command to the sensor, and then acts.
struct Acting {
  Acting() {
    const int p = skill.processor("P");
    skill.devices = {"sensor"};
    const int command = skill.channel("A", "command", "sensor");
    skill.channels.back().to_device = true;
    const int send = skill.statement("send", 1ms);
    const int act = skill.statement("act", 1ms);
    const int end = skill.statement("end", 1ms);
    skill.thread("A", p, 1, [=, this](Thread& t) -> Task {
      co_await t.send(send, command);
      co_await t.perform(act, [this] {
        if (work) work();
      });
      co_await t.complete(end, 0);
    });
  }
  void run(Telling& device) {
    RunOptions options;
    options.real_time.emplace();
    options.real_time->hang_timeout = 900ms;
    options.real_time->hang_status = 71;
    if (skill.on_promise_broken) options.on_broken_promise = runtime::OnBrokenPromise::contingency;
    const auto outcome = test::run(skill, {&device}, options);
    say(outcome.reason);
  }
  WrittenSkill skill;
  std::function<void()> work;
};

[[noreturn]] void spin() {
  static std::atomic<int> turns = 0;
  for (;;) ++turns;
}

}  // namespace

TEST_CASE("attach, open and start that do not return end the process, devices closed") {
  const int where = GENERATE(0, 1, 2);
  const Ended ended = in_a_child([where] {
    struct Stuck final : ScriptedDevice {
      Stuck() : ScriptedDevice("last", {{"order", true, {}}}) {}
      void attach(runtime::DeviceHost& host) override {
        ScriptedDevice::attach(host);
        if (where == 0) spin();
      }
      void open() override {
        if (where == 1) spin();
      }
      int where = -1;
    } stuck;
    stuck.where = where;
    Acting acting;
    acting.skill.devices = {"sensor", "last"};
    const int order = acting.skill.channel("A", "order", "last");
    acting.skill.channels.back().to_device = true;
    const int send = acting.skill.statement("send", 1ms);
    acting.skill.bodies.front() = [=](Thread& t) -> Task {
      if (where == 2) spin();  // as the skill is started, it comes to its first statement
      co_await t.send(send, order);
    };
    Telling device;
    RunOptions options;
    options.real_time.emplace();
    options.real_time->hang_timeout = 300ms;
    options.real_time->hang_status = 71;
    say(run(acting.skill, {&device, &stuck}, options).reason);
  });
  CAPTURE(ended.said);
  CHECK(ended.status == 71);
  CHECK(ended.said.find("sensor closed\n") != std::string::npos);
  CHECK(ended.said.find(where == 2 ? "the start of the skill has not returned"
                                   : "device last has not returned") != std::string::npos);
}

TEST_CASE("next_event and wait_until of a world apart that do not return end the process") {
  const bool waits = GENERATE(false, true);
  const Ended ended = in_a_child([waits] {
    struct Slow final : runtime::World {
      void advance_to(runtime::Time) override {}
      runtime::Time next_event() override {
        if (!waits) spin();
        return 20ms;
      }
      runtime::Time wait_until(runtime::Time) override { spin(); }
      bool apart() const override { return true; }
      bool waits = false;
    } world;
    world.waits = waits;
    Acting acting;
    const int never = acting.skill.channel("B", "never", "A");
    const int rest = acting.skill.statement("rest", 1ms);
    acting.skill.bodies.front() = [=](Thread& t) -> Task { co_await t.wait_within(rest, 5s, from(never)); };
    Telling device;
    RunOptions options;
    options.real_time.emplace();
    options.real_time->hang_timeout = 300ms;
    options.real_time->hang_status = 71;
    runtime::Device* devices[] = {&device};
    say(runtime::Dispatcher(devices, world).run(acting.skill, {}, options).reason);
  });
  CAPTURE(ended.said);
  CHECK(ended.status == 71);
  CHECK(ended.said.find("sensor closed\n") != std::string::npos);
  CHECK(ended.said.find(waits ? "the world was to wait for an instant that was over"
                              : "the world with its devices has not returned") != std::string::npos);
}

TEST_CASE("an activity that does not return ends the process, devices closed") {
  const bool spins = GENERATE(true, false);
  const Ended ended = in_a_child([spins] {
    Acting acting;
    Telling device;
    acting.work = [spins] {
      if (spins) spin();
      for (;;) ::pause();
    };
    acting.run(device);
  });
  CAPTURE(ended.said);
  CHECK(ended.status == 71);
  CHECK(ended.said.find("sensor closed\npal: A at act (written.pal:2) has not returned for ") == 0);
  CHECK(ended.said.find("its worst time is 1 ms\n  the devices are closed; the process ends") !=
        std::string::npos);
}

TEST_CASE("a device that does not return ends the process, devices closed") {
  const Ended ended = in_a_child([] {
    Acting acting;
    Telling device;
    device.on_receive = [](runtime::DeviceHost&, std::size_t, std::span<const double>) { spin(); };
    acting.run(device);
  });
  CAPTURE(ended.said);
  CHECK(ended.status == 71);
  CHECK(ended.said.find("sensor closed\npal: device sensor has not returned for ") == 0);
}

TEST_CASE("an answer to a broken promise that does not return is named, not the device") {
  const Ended ended = in_a_child([] {
    Acting acting;
    Telling device;
    acting.work = [] {  // its worst time is 1 ms
      for (const auto end = std::chrono::steady_clock::now() + 50ms;
           std::chrono::steady_clock::now() < end;) {
      }
    };
    acting.skill.on_promise_broken = [](const runtime::BrokenPromise&) -> bool { spin(); };
    acting.run(device);
  });
  CAPTURE(ended.said);
  CHECK(ended.status == 71);
  CHECK(ended.said.find("pal: the skill's answer to a broken promise has not returned for ") !=
        std::string::npos);
}

TEST_CASE("a close that does not return ends the process, with a message") {
  const Ended ended = in_a_child([] {
    Acting acting;
    Telling device;
    device.stuck = true;
    acting.work = [] { spin(); };
    acting.run(device);
  });
  CAPTURE(ended.said);
  CHECK(ended.status == 71);
  CHECK(ended.said.find("THE DEVICES COULD NOT BE CLOSED") != std::string::npos);
}

TEST_CASE("a close that does not return after a good end ends the process") {
  const Ended ended = in_a_child([] {
    Acting acting;
    Telling device;
    device.stuck = true;
    acting.run(device);
  });
  CAPTURE(ended.said);
  CHECK(ended.status == 71);
  CHECK(ended.said.find("sensor closed\npal: closing device sensor has not returned for ") == 0);
}

TEST_CASE("real time: without the right to SCHED_FIFO a skill runs, and the outcome says so") {
  const Ended ended = in_a_child([] {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_RTPRIO, &none);
    ::setrlimit(RLIMIT_MEMLOCK, &none);
    if (::getuid() == 0 && ::setuid(65534) != 0) ::_exit(1);
    Acting acting;
    Telling device;
    RunOptions options;
    options.real_time.emplace();
    const auto outcome = run(acting.skill, {&device}, options);
    for (const std::string& text : outcome.real_time->shortcomings) say(text + "\n");
    say(outcome.reason);
  });
  CAPTURE(ended.said);
  CHECK(ended.status == 0);
  const auto times = [&ended](const std::string& text) {
    int count = 0;
    for (auto at = ended.said.find(text); at != std::string::npos; at = ended.said.find(text, at + 1))
      ++count;
    return count;
  };
  CHECK(times("SCHED_FIFO is not permitted (Operation not permitted)") == 1);
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  // A sanitizer takes the call that locks memory, does nothing, and says that it is done.
#else
  CHECK(times("memory is not locked (") == 1);
#endif
  CHECK(ended.said.find("done") != std::string::npos);
}
