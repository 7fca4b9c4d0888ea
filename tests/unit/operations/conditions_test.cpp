// Several conditions in one test or wait, hysteresis, the mean of readings; zeroing.
#include <sstream>

#include "operations/step_log.hpp"
#include "operations/storyboard.hpp"
#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;
using test::operation;
using test::program_of;

namespace {

const std::string exits =
    R"({"id": "c", "kind": "case", "ways": [{"codes": [0], "to": "no"}, {"codes": [1], "to": "yes"}]},)"
    R"({"id": "no", "kind": "exit"}, {"id": "yes", "kind": "exit"}, {"id": "blind", "kind": "exit"})";

std::string tested(const std::string& fields) {
  return operation(R"({"id": "a", "kind": "test", )" + fields + R"(, "next": "c", "error": "blind"}, )" +
                   exits);
}

int code_of(const std::string& text, std::deque<double> readings) {
  test::ScriptedRunner runner;
  runner.readings = std::move(readings);
  Executor executor(program_of(text), runner);
  CHECK(executor.run() == ExecutionState::ended);
  return executor.last_code();
}

}  // namespace

TEST_CASE("all conditions or any of them") {
  const std::string two =
      R"([{"sensor": "eye", "at-least": 10}, {"sensor": "ear", "at-most": 5, "at-least": 1}])";
  const std::string all = tested("\"all\": " + two), any = tested("\"any\": " + two);
  CHECK(code_of(all, {10, 5}) == 1);
  CHECK(code_of(all, {9, 5}) == 0);
  CHECK(code_of(all, {10, 6}) == 0);
  CHECK(code_of(any, {9, 5}) == 1);
  CHECK(code_of(any, {10, 0}) == 1);
  CHECK(code_of(any, {9, 0}) == 0);
  CHECK(code_of(any, {}) == no_value);
  test::ScriptedRunner runner;
  runner.readings = {10, 5};
  std::ostringstream out;
  StepLog log(out);
  Executor executor(program_of(all), runner, &log);
  executor.run();
  CHECK(runner.sensed == std::vector<std::string>{"eye", "ear"});
  const auto step = parse_log_line(out.str());
  REQUIRE(step);
  CHECK(step->sensor == "eye, ear");
  REQUIRE(step->readings.size() == 2);
  CHECK(step->readings[1].name == "ear");
  CHECK(step->readings[1].value == 5);
  CHECK(log_line(*step) + "\n" == out.str());
}

TEST_CASE("a single condition is a test of its own") {
  const std::string text = tested(R"("sensor": "eye", "at-least": 10, "at-most": 20)");
  CHECK(code_of(text, {10}) == 1);
  CHECK(code_of(text, {21}) == 0);
}

TEST_CASE("the mean of several readings counts") {
  const std::string text = tested(R"("sensor": "eye", "limits": [10], "mean-of": 4)");
  CHECK(code_of(text, {8, 8, 12, 12}) == 1);
  CHECK(code_of(text, {8, 8, 12, 11}) == 0);
}

TEST_CASE("what was met stays met until the reading is well beyond") {
  test::ScriptedRunner runner;
  const std::string again =
      R"({"id": "c", "kind": "skill", "skill": "go", "next": "a", "error": "a"}, {"id": "blind", "kind": "exit"})";
  std::vector<int> codes;
  struct Codes final : StepObserver {
    explicit Codes(std::vector<int>& all) : codes(all) {}
    void done(const Step& step) override {
      if (!step.sensor.empty()) codes.push_back(step.result.code);
    }
    std::vector<int>& codes;
  } observer(codes);
  SECTION("limits") {
    runner.readings = {9, 10, 9.5, 20, 18.5, 17.9, 7.9, 9};
    Executor executor(
        program_of(operation(
            R"({"id": "a", "kind": "test", "sensor": "eye", "limits": [10, 20], "hysteresis": 2, "next": "c", "error": "blind"}, )" +
            again)),
        runner, &observer);
    executor.run(16);
    CHECK(codes == std::vector<int>{0, 1, 1, 2, 2, 1, 0, 0});
  }
  SECTION("conditions") {
    runner.readings = {9, 10, 8, 7.9, 9};
    Executor executor(
        program_of(operation(
            R"({"id": "a", "kind": "test", "sensor": "eye", "at-least": 10, "hysteresis": 2, "next": "c", "error": "blind"}, )" +
            again)),
        runner, &observer);
    executor.run(10);
    CHECK(codes == std::vector<int>{0, 1, 1, 0, 0});
  }
}

TEST_CASE("a wait waits for all its conditions") {
  test::ScriptedRunner runner;
  runner.readings = {9, 5, 10, 6, 10, 5};
  Executor executor(
      program_of(operation(
          R"({"id": "a", "kind": "wait", "all": [{"sensor": "eye", "at-least": 10}, {"sensor": "ear", "at-most": 5}], "timeout": 1, "next": "yes", "error": "no"},)"
          R"({"id": "yes", "kind": "exit"}, {"id": "no", "kind": "exit"})")),
      runner);
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(executor.token() == "yes");
  CHECK(runner.sensed.size() == 6);
}

TEST_CASE("a sensor is zeroed, or the reason is told") {
  const auto program = program_of(operation(
      R"({"id": "a", "kind": "zero", "sensor": "force-z", "next": "end", "error": "bad"}, {"id": "end", "kind": "exit"}, {"id": "bad", "kind": "exit"})"));
  test::ScriptedRunner runner;
  Executor executor(program, runner);
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(executor.token() == "end");
  CHECK(runner.zeroed == std::vector<std::string>{"force-z"});
  runner.zero_problem = "it is not in free air";
  executor.start_from("start");
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(executor.token() == "bad");
  CHECK(executor.last_code() == no_value);
  SECTION("and a stop cuts it off") {
    executor.start_from("start");
    runner.during_zero = [&] { executor.stop(); };
    CHECK(executor.run() == ExecutionState::stopped);
    CHECK(executor.token() == "a");
  }
}

TEST_CASE("a story tells conditions") {
  const auto program = program_of(
      tested(
          R"("any": [{"sensor": "eye", "at-least": 10, "mean-of": 3}, {"value": {"count-of": "s"}, "at-most": 5}])")
          .replace(0, 0, "")
          .insert(tested("").find("{\"id\": \"a\""),
                  R"({"id": "s", "kind": "skill", "skill": "go", "next": "a"}, )"));
  const std::string story = storyboard_markdown(program, {});
  INFO(story);
  CHECK(story.find(
            "It is looked whether the sensor eye shows 10 or more in the mean of 3 readings, or the count of "
            "s is 5 or less.") != std::string::npos);
}
