// Counted loops, retries and time limits.
#include "operations/codes.hpp"
#include "operations/graph.hpp"
#include "operations/ways.hpp"
#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;
using namespace std::chrono_literals;
using test::operation;
using test::program_of;
using Names = std::vector<std::string>;

namespace {

const std::string ends = R"({"id": "end", "kind": "exit"}, {"id": "bad", "kind": "exit", "code": 5})";

std::string skill(const std::string& fields) {
  return R"({"id": "a", "kind": "skill", "skill": "go", "next": "end", "error": "bad", )" + fields + "}, " +
         ends;
}

/// An operation `p` of two skills that runs as often as `repeat` says.
std::string repeated(const std::string& repeat) {
  return operation(
      R"({"id": "a", "kind": "operation", "operation": "p", "repeat": )" + repeat +
          R"(, "next": "end", "error": "bad"}, )" + ends,
      R"(, "operations": [{"name": "p", "icons": [{"id": "start", "kind": "start", "next": "x"},)"
      R"({"id": "x", "kind": "skill", "skill": "one", "next": "y", "error": "out"},)"
      R"({"id": "y", "kind": "skill", "skill": "two", "next": "done", "error": "out"},)"
      R"({"id": "done", "kind": "exit", "code": 0}, {"id": "out", "kind": "exit", "code": 3}]}])");
}

}  // namespace

TEST_CASE("an icon is repeated as often as it says") {
  test::ScriptedRunner runner;
  SECTION("a skill") {
    Executor executor(program_of(operation(skill(R"("repeat": 3)"))), runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(runner.ran == Names{"go", "go", "go"});
    CHECK(executor.last_code() == 0);
  }
  SECTION("a skill, until a code that is not normal") {
    runner.codes = {0, 4};
    Executor executor(program_of(operation(skill(R"("repeat": 3)"))), runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(runner.ran == Names{"go", "go"});
    CHECK(executor.token() == "bad");
  }
  SECTION("an operation") {
    Executor executor(program_of(repeated("2")), runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(runner.ran == Names{"one", "two", "one", "two"});
    CHECK(executor.token() == "end");
  }
  SECTION("an operation, until it ends otherwise than with 0") {
    runner.codes = {0, 0, 1};
    Executor executor(program_of(repeated("9")), runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(runner.ran == Names{"one", "two", "one"});
    CHECK(executor.token() == "bad");
  }
}

TEST_CASE("a loop can be halted between its rounds, and begins anew when the token comes again") {
  test::ScriptedRunner runner;
  Executor executor(
      program_of(
          operation(R"({"id": "a", "kind": "skill", "skill": "go", "repeat": 2, "next": "b", "error": "b"},)"
                    R"({"id": "b", "kind": "skill", "skill": "back", "next": "a", "error": "a"})")),
      runner);
  executor.add_breakpoint({"a", {}});
  CHECK(executor.run() == ExecutionState::paused);
  CHECK(runner.ran.empty());
  CHECK(executor.run() == ExecutionState::paused);
  CHECK(runner.ran == Names{"go"});
  executor.clear_breakpoints();
  runner.codes = {4, 0};  // the loop ends early here …
  executor.run(5);
  CHECK(runner.ran == Names{"go", "go", "back", "go", "go", "back"});  // … and has all its rounds again
}

TEST_CASE("a loop runs as often as something else has") {
  const auto text = operation(
      R"({"id": "a", "kind": "skill", "skill": "go", "next": "a", "error": "b"},)"
      R"({"id": "b", "kind": "skill", "skill": "back", "repeat": {"count-of": "a"}, "next": "end", "error": "end"}, )" +
      ends);
  for (const int rounds : {0, 1, 3}) {
    test::ScriptedRunner runner;
    runner.codes = std::deque<int>(static_cast<std::size_t>(rounds), 0);
    runner.codes.push_back(1);
    Executor executor(program_of(text), runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(std::count(runner.ran.begin(), runner.ran.end(), "back") == rounds);
    CHECK(executor.last_code() == 0);
  }
}

TEST_CASE("a skill begins again, as often as it may and with the codes that it names") {
  test::ScriptedRunner runner;
  SECTION("any") {
    runner.codes = {1, 9, 0};
    Executor executor(program_of(operation(skill(R"("retries": 2)"))), runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(runner.ran.size() == 3);
    CHECK(executor.token() == "end");
  }
  SECTION("not oftener") {
    runner.codes = {1, 1, 1, 1};
    Executor executor(program_of(operation(skill(R"("retries": 2)"))), runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(runner.ran.size() == 3);
    CHECK(executor.token() == "bad");
    CHECK(executor.steps() == 3);
  }
  SECTION("not with another code") {
    runner.codes = {1, 9, 0};
    Executor executor(program_of(operation(skill(R"("retries": 5, "retry-on": [1])"))), runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(runner.ran.size() == 2);
    CHECK(executor.token() == "bad");
  }
  SECTION("as often again in the next round") {
    runner.codes = {1, 0, 1, 0};
    Executor executor(program_of(operation(skill(R"("retries": 1, "repeat": 2)"))), runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(runner.ran.size() == 4);
    CHECK(executor.token() == "end");
  }
}

TEST_CASE("a skill that takes too long ends with a code of its own") {
  test::ScriptedRunner runner;
  runner.lasts = 3s;
  Executor executor(program_of(operation(skill(R"("time-limit": 2.5)"))), runner);
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(runner.last_limit == Duration(2500ms));
  CHECK(executor.token() == "bad");
  runner.lasts = 2s;
  executor.start_from("start");
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(executor.token() == "end");
  const auto program = program_of(operation(skill(R"("time-limit": 2.5)")));
  const auto limited = endings_of(Graph(program), {0, 1}, {}, {});
  REQUIRE(limited.size() == 2);
  CHECK(limited[1].code == time_over);
}

TEST_CASE("the longest time of loops counts rounds and attempts") {
  Skills skills;
  pan::Completion done, none;
  none.code = 1;
  none.kind = pan::Completion::Kind::contingency;
  skills["go"].completions = skills["one"].completions = skills["two"].completions = {done, none};
  const SkillTimes times{{{{"go", 0}, 2s},
                          {{"go", 1}, 3s},
                          {{"one", 0}, 2s},
                          {{"one", 1}, 2s},
                          {{"two", 0}, 3s},
                          {{"two", 1}, 3s}}};
  const auto longest = [&](const std::string& text) {
    return ways_through(program_of(text), skills, times).ways.at(0).longest;
  };
  CHECK(longest(operation(skill(R"("repeat": 4)"))) == Duration(8s));
  CHECK(longest(operation(skill(R"("retries": 4)"))) == Duration(14s));
  CHECK(longest(repeated("3")) == Duration(15s));
  const Ways counted = ways_through(
      program_of(operation(
          R"({"id": "a", "kind": "skill", "skill": "go", "repeat": {"count-of": "a"}, "next": "end", "error": "end"}, )" +
          ends)),
      skills, times);
  CHECK_FALSE(counted.ways.at(0).longest);
  CHECK(counted.ways.at(0).unbounded == Names{"the count of a"});
}
