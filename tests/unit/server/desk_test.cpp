// One client has the controls, every client may stop, and no command gets lost.
#include "tests/unit/server/support.hpp"

using namespace pal;
using namespace pal::server;
using operations::ExecutionState;

namespace {

struct Events final : EventSink {
  void happened(const Event& event) override {
    const std::lock_guard lock(mutex);
    numbers_follow = numbers_follow && event.number == last + 1;
    last = event.number;
    if (const auto* state = std::get_if<StateChanged>(&event.what)) states.push_back(state->state);
    changed.notify_all();
  }
  /// Until this many states have been told.
  void wait(std::size_t count) {
    std::unique_lock lock(mutex);
    REQUIRE(changed.wait_for(lock, std::chrono::seconds(5), [&] { return states.size() >= count; }));
  }
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<ExecutionState> states;
  std::uint64_t last = 0;
  bool numbers_follow = true;
};

struct Fixture {
  test::Clockwork cell;
  Events events;
  Desk desk{cell, test::clockwork_skills(), events};
  ClientId ann = desk.enter("ann"), bob = desk.enter("bob");

  std::string ask(ClientId client, Command command) {
    std::string said = "not yet";
    desk.ask(client, std::move(command), [&said](const Reply& reply) {
      const auto* refusal = std::get_if<Refusal>(&reply);
      said = refusal == nullptr ? "done" : refusal->text();
    });
    return said;
  }
  std::string load(ClientId client, const char* text) {
    return ask(client, LoadOperation{{{"o", text}}, "o"});
  }
};

}  // namespace

TEST_CASE("the controls belong to one client, every client may pause and stop") {
  Fixture f;
  CHECK(f.load(f.ann, test::two_long) == "done");
  CHECK(f.desk.status(f.ann).yours);
  CHECK(f.ask(f.bob, RunOperation{}) == "'ann' has the controls; other clients may only pause and stop");
  CHECK(f.ask(f.bob, TakeControls{}) == "'ann' has the controls; other clients may only pause and stop");
  CHECK(f.cell.runs == 0);
  const test::Worker worker(f.desk);
  CHECK(f.ask(f.ann, RunOperation{}) == "done");
  f.cell.wait_until_inside();
  CHECK(f.ask(f.ann, RunOperation{}) == "an operation runs; pause or stop it first");
  CHECK(f.ask(f.ann, SetParameter{"a", "code", 1.0}) == "an operation runs; pause or stop it first");
  CHECK(f.ask(f.bob, Pause{}) == "done");
  f.cell.let_go();
  f.events.wait(2);
  CHECK(f.desk.status(f.bob).state == ExecutionState::paused);
  CHECK(f.desk.status(f.bob).token == "b");
  CHECK(f.ask(f.ann, SetParameter{"b", "code", 99.0}) != "done");
  CHECK(f.ask(f.ann, SetParameter{"b", "code", 3.0}) == "done");
  f.cell.hold();
  CHECK(f.ask(f.ann, RunOperation{RunOperation::How::resume}) == "done");
  f.cell.wait_until_inside();
  CHECK(f.ask(f.bob, Stop{}) == "done");
  f.events.wait(4);
  CHECK(f.desk.status(f.bob).state == ExecutionState::stopped);
  CHECK(f.cell.runs == 2);
  CHECK(f.events.numbers_follow);
}

TEST_CASE("what is refused does not take the controls") {
  Fixture f;
  CHECK(f.load(f.ann, "no operation") != "done");
  CHECK(f.ask(f.ann, RunOperation{}) == "no operation is loaded");
  CHECK(f.ask(f.ann, RunSkill{"none", {}}) != "done");
  CHECK(f.desk.status(f.ann).holder.empty());
  CHECK(f.load(f.bob, test::two_long) == "done");
  CHECK(f.ask(f.bob, ReleaseControls{}) == "done");
  CHECK(f.ask(f.ann, PutToken{"nowhere"}) != "done");
  CHECK(f.ask(f.ann, SetParameter{"a", "code", 99.0}) != "done");
  CHECK(f.ask(f.ann, SetBreakpoint{{"nowhere", {}}}) != "done");
  CHECK(f.ask(f.ann, RunOperation{RunOperation::How::resume}) != "done");
  CHECK(f.desk.status(f.ann).holder.empty());
  CHECK(f.ask(f.bob, TakeControls{}) == "done");
}

TEST_CASE("a stop right behind a command holds, however the threads run") {
  for (int i = 0; i < 200; ++i) {
    Fixture f;
    f.load(f.ann, test::two_long);
    {
      const test::Worker worker(f.desk);
      f.ask(f.ann, RunOperation{});
      f.ask(f.bob, Stop{});
      f.events.wait(2);
    }
    REQUIRE(f.desk.status(f.ann).state == ExecutionState::stopped);
  }
}

TEST_CASE("a skill alone answers when it has ended, and can be stopped") {
  Fixture f;
  std::optional<Done> done;
  f.desk.ask(f.ann, RunSkill{"quick", {{"code", 4.0, {}, {}}}},
             [&](const Reply& reply) { done = std::get<Done>(reply); });
  CHECK_FALSE(done);
  CHECK(f.desk.work());
  REQUIRE(done);
  CHECK(done->result.code == 4);
  CHECK(f.ask(f.ann, RunSkill{"slow", {}}) != "not yet");
  CHECK(f.ask(f.ann, RunSkill{"quick", {{"code", 10.0, {}, {}}}}) != "not yet");
  CHECK(f.ask(f.ann, Pause{}) == "nothing runs");
  done.reset();
  f.desk.ask(f.ann, RunSkill{"long", {}}, [&](const Reply& reply) { done = std::get<Done>(reply); });
  std::thread stopper([&] {
    f.cell.wait_until_inside();
    f.ask(f.bob, Stop{});
  });
  f.desk.work();
  stopper.join();
  REQUIRE(done);
  CHECK(done->result.kind == operations::SkillResult::Kind::stopped);
}

TEST_CASE(
    "when the client goes that has the controls, the operation pauses or goes on, and another takes over") {
  const bool pauses = GENERATE(true, false);
  test::Clockwork cell;
  Events events;
  Desk desk(cell, test::clockwork_skills(), events, {"cell", pauses, nullptr});
  const ClientId ann = desk.enter("ann"), bob = desk.enter("bob");
  const auto ask = [&](ClientId client, Command command) {
    bool done = false;
    desk.ask(client, std::move(command),
             [&](const Reply& reply) { done = std::holds_alternative<Done>(reply); });
    return done;
  };
  REQUIRE(ask(ann, LoadOperation{{{"o", test::two_long}}, "o"}));
  const test::Worker worker(desk);
  REQUIRE(ask(ann, RunOperation{}));
  cell.wait_until_inside();
  desk.leave(ann);
  CHECK(desk.status(bob).holder.empty());
  cell.let_go();
  events.wait(2);
  CHECK(desk.status(bob).state == (pauses ? ExecutionState::paused : ExecutionState::ended));
  CHECK(ask(bob, RunOperation{}));
  CHECK(desk.status(bob).yours);
  events.wait(4);
  CHECK(desk.status(bob).state == ExecutionState::ended);
}

TEST_CASE("breakpoints can be set while an operation runs") {
  Fixture f;
  f.load(f.ann, test::two_long);
  const test::Worker worker(f.desk);
  f.ask(f.ann, RunOperation{});
  f.cell.wait_until_inside();
  std::atomic<bool> set = false;
  f.desk.ask(f.ann, SetBreakpoint{{"b", {}}},
             [&](const Reply& reply) { set = std::holds_alternative<Done>(reply); });
  CHECK_FALSE(set);
  f.cell.let_go();
  f.events.wait(2);
  CHECK(set);
  CHECK(f.desk.status(f.ann).token == "b");
  CHECK(f.desk.status(f.ann).reason == "breakpoint at b");
}

TEST_CASE("only sensors and locations of the cell are taken") {
  test::Clockwork cell;
  Events events;
  DeskOptions options;
  options.sensors = {{"eye", {"mm", "what it sees"}}};
  Desk desk(cell, test::clockwork_skills(), events, options);
  const ClientId ann = desk.enter("ann");
  const auto load = [&](const std::string& sensor) {
    std::string said = "done";
    const std::string text =
        R"({"operation-format": 1, "name": "o", "icons": [{"id": "start", "kind": "start", "next": "a"}, {"id": "a", "kind": "test", "sensor": ")" +
        sensor + R"(", "limits": [10], "next": "end", "error": "end"}, {"id": "end", "kind": "exit"}]})";
    desk.ask(ann, LoadOperation{{{"o", text}}, "o"}, [&](const Reply& reply) {
      if (const auto* refusal = std::get_if<Refusal>(&reply)) said = refusal->text();
    });
    return said;
  };
  CHECK(load("eyes").find("the cell has no sensor 'eyes'; did you mean 'eye'?") != std::string::npos);
  CHECK(load("eye") == "done");
  desk.ask(ann, RunOperation{}, [](const Reply&) {});
  CHECK(desk.work());
  CHECK(desk.status(ann).last_code == 1);
}

TEST_CASE("an operation that is wrong is refused with its place") {
  Fixture f;
  CHECK(f.load(f.ann, "{") != "done");
  const std::string said = f.load(
      f.ann,
      R"({"operation-format": 1, "name": "o", "icons": [{"id": "start", "kind": "start", "next": "x"}]})");
  CHECK(said.rfind("o:1:", 0) == 0);
  CHECK(f.ask(f.ann, RunOperation{}) == "no operation is loaded");
}
