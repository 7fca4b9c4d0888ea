// The token goes where the codes send it, and halts at breakpoints.
#include <nlohmann/json.hpp>
#include <sstream>

#include "operations/step_log.hpp"
#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;
using pal::test::looping;
using pal::test::operation;
using pal::test::program_of;
using Names = std::vector<std::string>;

TEST_CASE("a CASE sends the token by the last completion code") {
  test::ScriptedRunner runner;
  runner.codes = {1, 1, 0, 0};
  Executor executor(program_of(operation(looping)), runner);
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(runner.ran == Names{"go", "go", "go", "back"});
  CHECK(executor.steps() == 4);
  CHECK(executor.reason() == "exit 'end' with code 0");
  CHECK(executor.run() == ExecutionState::ended);  // and that was all
  CHECK(runner.ran.size() == 4);
  CHECK(runner.initialised == 1);
}

TEST_CASE("a code that no icon handles ends the operation") {
  test::ScriptedRunner runner;
  SECTION("behind a CASE") {
    runner.codes = {7};
    Executor executor(program_of(operation(looping)), runner);
    CHECK(executor.run() == ExecutionState::failed);
    CHECK(executor.reason() == "CASE 'case' has no way for code 7");
  }
  SECTION("without one") {
    runner.codes = {0, 3};
    Executor executor(program_of(operation(looping)), runner);
    CHECK(executor.run() == ExecutionState::failed);
    CHECK(executor.reason() == "'b' ended with code 3, which no icon handles: as told");
    CHECK(executor.token() == "b");
  }
  SECTION("a cell that is not ready runs nothing") {
    runner.problem = "no power";
    Executor executor(program_of(operation(looping)), runner);
    CHECK(executor.run() == ExecutionState::failed);
    CHECK(runner.ran.empty());
  }
}

TEST_CASE("error takes what a CASE does not name") {
  const auto program = program_of(
      operation(R"({"id": "a", "kind": "skill", "skill": "go", "next": "case", "error": "bad"},)"
                R"({"id": "case", "kind": "case", "ways": [{"codes": [1], "to": "end"}], "default": "end"},)"
                R"({"id": "end", "kind": "exit"}, {"id": "bad", "kind": "exit", "code": 5})"));
  for (const auto& [code, exit] : {std::pair{0, 0}, {1, 1}, {3, 5}, {9, 5}}) {
    test::ScriptedRunner runner;
    runner.codes = {code};
    Executor executor(program, runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(executor.last_code() == exit);
  }
}

TEST_CASE("a step is one skill") {
  test::ScriptedRunner runner;
  runner.codes = {1};
  Executor executor(program_of(operation(looping)), runner);
  CHECK(executor.step() == ExecutionState::paused);
  CHECK(executor.token() == "a");  // by way of the CASE
  CHECK(executor.step() == ExecutionState::paused);
  CHECK(executor.token() == "b");
  CHECK(executor.step() == ExecutionState::ended);
  CHECK(runner.ran == Names{"go", "go", "back"});
}

TEST_CASE("a pause waits for the skill, and runs nothing twice") {
  test::ScriptedRunner runner;
  Executor executor(program_of(operation(looping)), runner);
  runner.during = [&] { executor.pause(); };
  CHECK(executor.run() == ExecutionState::paused);
  CHECK(runner.ran == Names{"go"});
  runner.during = nullptr;
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(runner.ran == Names{"go", "back"});
}

TEST_CASE("a stop cuts the skill off, which runs again from its beginning") {
  test::ScriptedRunner runner;
  Executor executor(program_of(operation(looping)), runner);
  runner.during = [&] { executor.stop(); };
  CHECK(executor.run() == ExecutionState::stopped);
  CHECK(executor.token() == "a");
  runner.during = nullptr;
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(runner.ran == Names{"go", "go", "back"});
}

TEST_CASE("a stop before the first skill runs none") {
  test::ScriptedRunner runner;
  Executor executor(program_of(operation(looping)), runner);
  executor.stop();
  CHECK(executor.run() == ExecutionState::stopped);
  CHECK(runner.ran.empty());
  CHECK(executor.run() == ExecutionState::ended);
}

TEST_CASE("breakpoints halt before an icon, also only with a code") {
  test::ScriptedRunner runner;
  runner.codes = {1, 0};
  Executor executor(program_of(operation(looping)), runner);
  executor.add_breakpoint({"case", 0});
  CHECK(executor.run() == ExecutionState::paused);
  CHECK(executor.token() == "case");
  CHECK(runner.ran == Names{"go", "go"});
  executor.add_breakpoint({"b", {}});
  CHECK(executor.run() == ExecutionState::paused);
  CHECK(executor.token() == "b");
  CHECK(executor.run() == ExecutionState::ended);
  CHECK_THROWS_WITH(executor.add_breakpoint({"c", {}}), "operation 'o' has no icon 'c'");
}

TEST_CASE("a count says how often an icon has ended normally since START") {
  test::ScriptedRunner runner;
  runner.codes = {0, 1, 0, 0, 0};
  Executor executor(
      program_of(operation(
          R"({"id": "a", "kind": "skill", "skill": "put", "parameters": {"n": {"count-of": "a"}}, "next": "a", "error": "b"},)"
          R"({"id": "b", "kind": "skill", "skill": "empty", "next": "again"}, {"id": "again", "kind": "restart"})")),
      runner);
  std::vector<double> counted;
  runner.during = [&] {
    if (!runner.last_parameters.empty()) counted.push_back(std::get<double>(runner.last_parameters[0].value));
  };
  executor.run(5);
  CHECK(counted == std::vector<double>{0, 1, 0, 1});  // the code 1 does not count, RESTART sets it to 0
}

TEST_CASE("parameters are changed while it is paused") {
  test::ScriptedRunner runner;
  runner.codes = {1};
  Cell cell;
  Skills& skills = cell.skills.emplace();
  skills["back"];
  pan::Parameter far;
  far.name = "far";
  far.high = 10;
  skills["go"].name = "go";
  skills["go"].parameters = {far};
  Executor executor(program_of(operation(looping)), runner, nullptr, &cell);
  executor.step();
  CHECK(std::get<double>(runner.last_parameters.at(0).value) == 3);
  executor.set_parameter("a", "far", 7.0);
  CHECK_THROWS_AS(executor.set_parameter("a", "far", 70.0), ExecutionError);
  CHECK_THROWS_AS(executor.set_parameter("a", "fra", 7.0), ExecutionError);
  CHECK_THROWS_AS(executor.set_parameter("case", "far", 7.0), ExecutionError);
  executor.step();
  CHECK(std::get<double>(runner.last_parameters.at(0).value) == 7);
  runner.during = [&] { CHECK_THROWS_AS(executor.set_parameter("a", "far", 1.0), ExecutionError); };
  executor.run();
}

TEST_CASE("a sub-operation hands its exit's code on, and can be entered in the middle") {
  const auto program = program_of(operation(
      R"({"id": "a", "kind": "operation", "operation": "p", "next": "end", "error": "bad"},)"
      R"({"id": "end", "kind": "exit"}, {"id": "bad", "kind": "exit"})",
      R"(, "operations": [{"name": "p", "icons": [{"id": "start", "kind": "start", "next": "x"},)"
      R"({"id": "x", "kind": "skill", "skill": "one", "next": "y"}, {"id": "y", "kind": "skill", "skill": "two", "next": "z"},)"
      R"({"id": "z", "kind": "exit", "code": 4}]}])"));
  test::ScriptedRunner runner;
  Executor executor(program, runner);
  executor.start_from("a/y");
  CHECK(executor.token() == "a/y");
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(runner.ran == Names{"two"});
  CHECK(executor.token() == "bad");
  CHECK(executor.last_code() == 4);
  executor.start_from("start");
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(runner.ran == Names{"two", "one", "two"});
}

TEST_CASE("the log has every step of ten thousand, the same bytes each time") {
  const auto program = program_of(operation(
      R"({"id": "a", "kind": "skill", "skill": "go", "next": "d"}, {"id": "d", "kind": "delay", "seconds": 0.5, "next": "r"},)"
      R"({"id": "r", "kind": "restart"})"));
  std::string first;
  for (int turn = 0; turn < 2; ++turn) {
    test::ScriptedRunner runner;
    std::ostringstream out;
    StepLog log(out);
    Executor executor(program, runner, &log);
    CHECK(executor.run(10'000) == ExecutionState::paused);
    CHECK(executor.steps() == 10'000);
    if (turn == 0) {
      first = out.str();
    } else {
      CHECK((first == out.str()));
    }
  }
  std::istringstream lines(first);
  std::size_t count = 0;
  double end = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto step = nlohmann::json::parse(line);
    CHECK(step.at("step") == ++count);
    CHECK(step.at("begin_s") == end);
    end = step.at("end_s");
  }
  CHECK(count == 10'000);
  CHECK(end == 7'500);
}
