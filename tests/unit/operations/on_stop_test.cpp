// The operation that runs when another one is stopped.
#include <sstream>

#include "operations/happened.hpp"
#include "operations/step_log.hpp"
#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;
using test::program_of;
using Names = std::vector<std::string>;

namespace {

std::string stoppable(const std::string& icons) {
  return R"({"operation-format": 1, "name": "o", "on-stop": "retreat", "icons": [{"id": "start", "kind": "start", "next": "a"}, )" +
         icons +
         R"(], "operations": [{"name": "retreat", "icons": [{"id": "start", "kind": "start", "next": "lift"},)"
         R"({"id": "lift", "kind": "skill", "skill": "up", "next": "done", "error": "done"}, {"id": "done", "kind": "exit"}]},)"
         R"({"name": "part", "icons": [{"id": "start", "kind": "start", "next": "x"},)"
         R"({"id": "x", "kind": "skill", "skill": "go", "next": "done", "error": "done"}, {"id": "done", "kind": "exit"}]}]})";
}

const std::string one = stoppable(
    R"({"id": "a", "kind": "skill", "skill": "go", "next": "end", "error": "end"}, {"id": "end", "kind": "exit"})");

}  // namespace

TEST_CASE("a stopped operation runs its operation on stop, once") {
  test::ScriptedRunner runner;
  std::ostringstream out;
  StepLog log(out);
  Executor executor(program_of(one), runner, &log);
  runner.during = [&] {
    if (runner.ran.back() == "go") executor.stop();
  };
  CHECK(executor.run() == ExecutionState::stopped);
  CHECK(runner.ran == Names{"go", "up"});
  CHECK(executor.token() == "a");
  CHECK(executor.reason() == "stopped in a; then 'retreat' ended with code 0");
  CHECK(out.str().find("\"on-stop/lift\"") != std::string::npos);
  runner.during = nullptr;
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(runner.ran == Names{"go", "up", "go"});
  const auto program = program_of(one);
  REQUIRE(find_path(program, "on-stop/lift").size() == 1);
  CHECK(find_path(program, "on-stop/lift")[0].operation == 1);
}

TEST_CASE("a second stop ends the operation on stop") {
  test::ScriptedRunner runner;
  Executor executor(program_of(one), runner);
  runner.during = [&] { executor.stop(); };
  CHECK(executor.run() == ExecutionState::stopped);
  CHECK(runner.ran == Names{"go", "up"});
  CHECK(executor.reason() == "stopped in a; then 'retreat' was stopped: stopped in on-stop/lift");
  CHECK(executor.token() == "a");
}

TEST_CASE("pauses, breakpoints and steps do not hold up the operation on stop") {
  test::ScriptedRunner runner;
  Executor executor(program_of(one), runner);
  executor.add_breakpoint({"end", {}});
  runner.during = [&] {
    if (runner.ran.back() == "go") executor.stop();
    executor.pause();
  };
  CHECK(executor.step() == ExecutionState::stopped);
  CHECK(runner.ran == Names{"go", "up"});
  runner.during = nullptr;
  CHECK(executor.run() == ExecutionState::paused);  // at the breakpoint, not by the old pause
  CHECK(executor.token() == "end");
}

TEST_CASE("the innermost operation on stop runs, and none before anything has run") {
  test::ScriptedRunner runner;
  Executor executor(
      program_of(
          stoppable(R"({"id": "a", "kind": "operation", "operation": "part", "next": "end", "error": "end"},)"
                    R"({"id": "end", "kind": "exit"})")),
      runner);
  executor.stop();
  CHECK(executor.run() == ExecutionState::stopped);
  CHECK(runner.ran.empty());
  runner.during = [&] {
    if (runner.ran.back() == "go") executor.stop();
  };
  CHECK(executor.run() == ExecutionState::stopped);
  CHECK(runner.ran == Names{"go", "up"});  // of the operation around the part
  CHECK(executor.token() == "a/x");
}

TEST_CASE("an operation on stop must be there") {
  const std::string text = std::string(one).replace(one.find("\"retreat\""), 9, "\"retraet\"");
  MemoryFileSystem files;
  files.add("o.op.json", text);
  SourceManager sources;
  Diagnostics diagnostics;
  const auto program = load(files, sources, "o.op.json", diagnostics);
  REQUIRE(program);
  check_shape(*program, diagnostics);
  REQUIRE(diagnostics.errors() == 1);
  CHECK(diagnostics.all()[0].hint == "did you mean 'retreat'?");
}
