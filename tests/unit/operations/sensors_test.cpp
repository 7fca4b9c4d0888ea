// Tests and waits: what the sensor shows decides where the token goes.
#include <sstream>

#include "operations/codes.hpp"
#include "operations/step_log.hpp"
#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;
using test::operation;
using test::program_of;
using namespace std::chrono_literals;

namespace {

/// A test with two limits, and an exit a code.
const char* const three_ways =
    R"({"id": "a", "kind": "test", "sensor": "eye", "limits": [10, 20], "next": "case", "error": "blind"},)"
    R"({"id": "case", "kind": "case", "ways": [{"codes": [0], "to": "low"}, {"codes": [1], "to": "middle"}, {"codes": [2], "to": "high"}]},)"
    R"({"id": "low", "kind": "exit"}, {"id": "middle", "kind": "exit"}, {"id": "high", "kind": "exit"}, {"id": "blind", "kind": "exit"})";

/// Waits for 5 to 6 for a second at most.
const char* const waiting =
    R"({"id": "a", "kind": "wait", "sensor": "eye", "at-least": 5, "at-most": 6, "timeout": 1, "next": "end", "error": "vain"},)"
    R"({"id": "end", "kind": "exit"}, {"id": "vain", "kind": "exit"})";

}  // namespace

TEST_CASE("a test's code is how many limits the reading has reached") {
  const double reading = GENERATE(-5.0, 9.99, 10.0, 19.9, 20.0, 1e9);
  const int code = reading < 10 ? 0 : reading < 20 ? 1 : 2;
  test::ScriptedRunner runner;
  runner.readings = {reading};
  std::ostringstream out;
  StepLog log(out);
  Executor executor(program_of(operation(three_ways)), runner, &log);
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(executor.token() ==
        std::vector<std::string>{"low", "middle", "high"}[static_cast<std::size_t>(code)]);
  CHECK(executor.last_code() == code);
  CHECK(runner.sensed == std::vector<std::string>{"eye"});
  const auto step = parse_log_line(out.str());
  REQUIRE(step);
  CHECK(step->sensor == "eye");
  CHECK(step->reading == reading);
  CHECK(step->result.code == code);
  CHECK(step->end == Duration(10ms));
}

TEST_CASE("a sensor that shows nothing leads to error with code -1") {
  test::ScriptedRunner runner;
  Executor executor(program_of(operation(three_ways)), runner);
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(executor.token() == "blind");
  CHECK(executor.last_code() == no_value);
}

TEST_CASE("a wait ends when the sensor shows it, or when its time is over") {
  test::ScriptedRunner runner;
  SECTION("it does") {
    runner.readings = {7, 4, 5.5};
    Executor executor(program_of(operation(waiting)), runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(executor.token() == "end");
    CHECK(runner.sensed.size() == 3);
  }
  SECTION("it does not") {
    runner.readings = {7};
    Executor executor(program_of(operation(waiting)), runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(executor.token() == "vain");
    CHECK(executor.last_code() == waited_in_vain);
    CHECK(runner.now() >= 1s);
    CHECK(runner.now() < 1100ms);
  }
}

TEST_CASE("a pause and a stop end a wait, which then begins again") {
  const bool stop = GENERATE(true, false);
  test::ScriptedRunner runner;
  runner.readings = {7};
  std::ostringstream out;
  StepLog log(out);
  Executor executor(program_of(operation(waiting)), runner, &log);
  runner.during_delay = [&] { stop ? executor.stop() : executor.pause(); };
  CHECK(executor.run() == (stop ? ExecutionState::stopped : ExecutionState::paused));
  CHECK(executor.token() == "a");
  CHECK(parse_log_line(out.str())->result.kind == SkillResult::Kind::stopped);
  runner.during_delay = nullptr;
  runner.readings = {5};
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(executor.token() == "end");
  CHECK(executor.steps() == 2);
}

TEST_CASE("a stop ends a delay, which then begins again") {
  test::ScriptedRunner runner;
  Executor executor(
      program_of(operation(
          R"({"id": "a", "kind": "delay", "seconds": 9, "next": "b"},)"
          R"({"id": "b", "kind": "skill", "skill": "go", "next": "end"}, {"id": "end", "kind": "exit"})")),
      runner);
  runner.during_delay = [&] { executor.stop(); };
  CHECK(executor.run() == ExecutionState::stopped);
  CHECK(executor.token() == "a");
  CHECK(runner.ran.empty());
  runner.during_delay = nullptr;
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(runner.ran == std::vector<std::string>{"go"});
}

TEST_CASE("the possible codes of a test and a wait are known") {
  const auto program = program_of(operation(three_ways));
  const auto codes = possible_codes(Graph(program), {});
  CHECK(codes.exits[0].list() == std::vector<int>{-1, 0, 1, 2});
  const auto waits = program_of(operation(waiting));
  CHECK(possible_codes(Graph(waits), {}).exits[0].list() == std::vector<int>{-1, 0, 1});
}

TEST_CASE("a step can be read again from its line") {
  for (const char* wrong :
       {"", "{", "[]", "7", R"({"step": 1})", R"({"step": 1, "icon": 3, "begin_s": 0, "end_s": 1})",
        R"({"step": 1, "icon": "a", "begin_s": 2, "end_s": 1})",
        R"({"step": 1, "icon": "a", "begin_s": 0, "end_s": 1e300})",
        R"({"step": 1, "icon": "a", "kind": "odd", "begin_s": 0, "end_s": 1})",
        R"({"step": 1, "icon": "a", "parameters": {"x": []}, "begin_s": 0, "end_s": 1})"}) {
    INFO(wrong);
    CHECK_FALSE(parse_log_line(wrong));
  }
  Step step{7,
            "p/x",
            "go",
            {{"far", 2.5, {}, {}}, {"to", std::string("HOME"), {}, {}}, {"on", true, {}, {}}},
            {SkillResult::Kind::contingency, 3, "so"},
            1500ms,
            2750ms};
  CHECK(log_line(*parse_log_line(log_line(step))) == log_line(step));
  CHECK(told(step) == "   7  p/x: go ended with code 3 after 1.250 s: so");
}
