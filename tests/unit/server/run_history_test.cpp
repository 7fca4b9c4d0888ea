// The history: what is noted of runs, pages of it, its limits, and what a crash leaves.
#include "server/run_history.hpp"

#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "server/access.hpp"
#include "server/disk_file.hpp"
#include "tests/unit/server/session_support.hpp"

using namespace pal;
using namespace pal::server;
using Json = nlohmann::json;

namespace {

struct DatabaseFolder {
  DatabaseFolder() { std::filesystem::create_directories(path); }
  ~DatabaseFolder() { std::filesystem::remove_all(path); }
  std::string file() const { return path + "/history.sqlite"; }
  std::string path = std::filesystem::temp_directory_path() / ("pal-history-" + make_token());
};

RunRecord run_of(const std::string& name) {
  RunRecord record;
  record.kind = RunRecord::Kind::operation;
  record.name = name;
  record.begun = std::chrono::system_clock::now();
  record.by = "ann";
  return record;
}

operations::Step step_of(std::size_t number, std::size_t length = 0) {
  operations::Step step;
  step.number = number;
  step.icon = "a";
  step.skill = "quick";
  step.result.reason = std::string(length, 'x');
  step.result.figures = {{"force", 4.5}};
  return step;
}

}  // namespace

TEST_CASE("the executions of a skill are told over all runs, the newest first") {
  RunHistory history("");
  for (int i = 0; i < 3; ++i) {
    const auto run = history.begin(run_of("all"));
    for (std::size_t number = 1; number <= 2; ++number) {
      operations::Step step = step_of(number);
      step.skill = number == 1 ? "quick" : "slow";
      step.result.measured = {{"fresh", 0.01}};
      history.step(run, step, {{"code", 3.0, {}, {}}});
    }
  }
  const StepPage first = history.steps_of("slow", std::nullopt, 2);
  REQUIRE(first.steps.size() == 2);
  CHECK(first.more);
  CHECK(first.steps[0].run == 3);
  CHECK(first.steps[0].name == "all");
  const Json step = Json::parse(first.steps[0].step.step);
  CHECK(step["skill"] == "slow");
  CHECK(step["step"] == 2);
  CHECK(step["measured"]["fresh"] == 0.01);
  CHECK(Json::parse(first.steps[0].step.parameters)["code"] == 3);
  const StepPage rest = history.steps_of("slow", first.steps.back().run, 10);
  CHECK(rest.steps.size() == 1);
  CHECK_FALSE(rest.more);
  CHECK(history.steps_of("none", std::nullopt, 10).steps.empty());
}

TEST_CASE("runs are told by page, the newest first, and by name") {
  RunHistory history("");
  for (int i = 0; i < 7; ++i) {
    const auto run = history.begin(run_of(i % 2 == 0 ? "even" : "odd"), "text");
    history.step(run, step_of(1), {{"code", 3.0, {}, {}}});
    history.change(run, "ended", Duration(std::chrono::seconds(2)), 4, "");
  }
  const RunPage first = history.list(std::nullopt, 3, "");
  REQUIRE(first.runs.size() == 3);
  CHECK(first.more);
  CHECK(first.runs[0].run == 7);
  CHECK(first.runs[0].code == 4);
  CHECK(first.runs[0].steps == 1);
  CHECK(first.runs[0].end == Duration(std::chrono::seconds(2)));
  const RunPage rest = history.list(first.runs.back().run, 10, "");
  CHECK(rest.runs.size() == 4);
  CHECK_FALSE(rest.more);
  CHECK(history.list(std::nullopt, 10, "odd").runs.size() == 3);
  const RunSteps read = history.read(7, 0, 10);
  CHECK(read.text == "text");
  REQUIRE(read.steps.size() == 1);
  CHECK(Json::parse(read.steps[0].step)["figures"]["force"] == 4.5);
  CHECK(Json::parse(read.steps[0].parameters)["code"] == 3);
  CHECK_THROWS_AS(history.read(99, 0, 10), StoreProblem);
}

TEST_CASE("steps are told by page") {
  RunHistory history("");
  const auto run = history.begin(run_of("long"));
  for (std::size_t i = 1; i <= 25; ++i) history.step(run, step_of(i), {});
  const RunSteps page = history.read(run, 20, 3);
  REQUIRE(page.steps.size() == 3);
  CHECK(Json::parse(page.steps[0].step)["step"] == 21);
  CHECK(page.more);
  CHECK_FALSE(history.read(run, 22, 3).more);
}

TEST_CASE("a history that is opened again counts on, and tells what was broken off") {
  const DatabaseFolder folder;
  {
    RunHistory history(folder.file());
    history.change(history.begin(run_of("one")), "ended", Duration{}, 0, "");
    history.begin(run_of("two"));
  }
  RunHistory history(folder.file());
  CHECK(history.begin(run_of("three")) == 3);
  const RunPage page = history.list(std::nullopt, 10, "");
  REQUIRE(page.runs.size() == 3);
  CHECK(page.runs[0].state == "running");
  CHECK(page.runs[1].state == "broken off");
  CHECK(page.runs[2].state == "ended");
}

TEST_CASE("what was told is there when the program is killed") {
  const DatabaseFolder folder;
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    RunHistory history(folder.file());
    const auto run = history.begin(run_of("one"));
    history.step(run, step_of(1), {});
    history.read(run, 0, 1);
    const char told = 1;
    if (::write(ends[1], &told, 1) != 1) ::_exit(1);
    for (;;) history.step(run, step_of(2, 1000), {});
  }
  char told = 0;
  REQUIRE(::read(ends[0], &told, 1) == 1);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ::close(ends[0]);
  ::close(ends[1]);
  RunHistory history(folder.file());
  CHECK(history.read(1, 0, 1).steps.size() == 1);
  CHECK(history.list(std::nullopt, 1, "").runs[0].state == "broken off");
}

TEST_CASE("the oldest runs go when the history is full") {
  SECTION("by number") {
    RunHistory history("", {5, std::uint64_t{1} << 30});
    for (int i = 0; i < 8; ++i) history.begin(run_of("one"));
    const RunPage page = history.list(std::nullopt, 10, "");
    REQUIRE(page.runs.size() == 5);
    CHECK(page.runs.back().run == 4);
  }
  SECTION("by size, on the disk too") {
    const DatabaseFolder folder;
    constexpr std::uint64_t most = 400'000;
    RunHistory history(folder.file(), {1000, most});
    for (int i = 0; i < 40; ++i) {
      const auto run = history.begin(run_of("one"));
      for (std::size_t step = 1; step <= 20; ++step) history.step(run, step_of(step, 1000), {});
      history.list(std::nullopt, 1, "");
    }
    const RunPage page = history.list(std::nullopt, 100, "");
    CHECK(page.runs.size() < 30);
    CHECK(page.runs.front().run == 40);
    CHECK(std::filesystem::file_size(folder.file()) < 2 * most);
  }
  SECTION("the first steps of one run that fills it alone") {
    RunHistory history("", {1000, 200'000});
    const auto run = history.begin(run_of("one"));
    for (std::size_t step = 1; step <= 2000; ++step) {
      history.step(run, step_of(step, 1000), {});
      if (step % 50 == 0) history.list(std::nullopt, 1, "");
    }
    const RunSteps read = history.read(run, 0, 1);
    REQUIRE(read.steps.size() == 1);
    CHECK(Json::parse(read.steps[0].step)["step"] > 1000);
  }
}

TEST_CASE("a history keeps on the disk what it keeps, with a file and without") {
  const DatabaseFolder folder;
  for (const std::string& file : {std::string(), folder.file()}) {
    RunHistory history(file);
    const auto run = history.begin(run_of("one"));
    constexpr std::size_t steps = 800, length = 20'000;
    for (std::size_t step = 1; step <= steps; ++step) {
      history.step(run, step_of(step, length), {});
      history.make_room();
    }
    // Each call waits a while for what is not written yet.
    while (history.list(std::nullopt, 1, "").runs.front().steps < steps) {
    }
    // This counts all databases of the program; what is kept is 16 MB.
    CHECK(::sqlite3_memory_used() < 6'000'000);
    CHECK(::sqlite3_memory_used() > 0);
  }
}

TEST_CASE("a file that is no history is refused, and stays") {
  const DatabaseFolder folder;
  std::ofstream(folder.file()) << std::string(5000, 'x');
  CHECK_THROWS_AS(RunHistory(folder.file()), StoreProblem);
  CHECK(std::filesystem::file_size(folder.file()) == 5000);
  CHECK_THROWS_AS(RunHistory("/nowhere/at/all"), StoreProblem);
}

TEST_CASE("the desk notes who ran what, with parameters that have their defaults") {
  RunHistory history("");
  DeskOptions options;
  options.runs = &history;
  test::SessionFixture cell(json_session, options);
  cell.context.runs = &history;
  const auto call = [&cell](const std::string& method, const Json& params = Json::object()) {
    auto all = cell.say(Json{{"jsonrpc", "2.0"}, {"id", 2}, {"method", method}, {"params", params}}.dump());
    for (std::string& each : cell.work()) all.push_back(std::move(each));
    for (const std::string& each : all)
      if (const Json message = Json::parse(each); message.contains("id")) {
        INFO(each);
        REQUIRE(message.contains("result"));
        return message["result"];
      }
    FAIL("no answer");
    return Json();
  };
  call("hello", {{"token", "secret"}, {"name", "ann"}});
  call("skill.run", {{"skill", "quick"}});
  call("operation.load", {{"main", "o"}, {"files", {{"o", test::endless}}}});
  call("operation.step");
  call("operation.step");
  CHECK(call("state")["run"] == 2);
  call("stop");
  call("operation.from", {{"icon", "a"}});
  call("operation.step");
  const Json runs = call("history.list")["runs"];
  REQUIRE(runs.size() == 3);
  CHECK(runs[0]["state"] == "paused");
  CHECK(runs[1]["state"] == "stopped");
  CHECK(runs[1]["steps"] == 2);
  CHECK(runs[1]["name"] == "endless");
  CHECK(runs[1]["by"] == "ann");
  CHECK(runs[2]["kind"] == "skill");
  CHECK(runs[2]["code"] == 0);
  CHECK(call("history.list", {{"limit", 1}})["more"] == true);
  const Json read = call("history.read", {{"run", 2}});
  CHECK(read["text"] == test::endless);
  CHECK(read["steps"].size() == 2);
  CHECK(read["steps"][1]["step"]["step"] == 2);
  CHECK(read["steps"][0]["parameters"]["code"] == 0);
  CHECK(call("history.read", {{"run", 1}})["steps"][0]["parameters"]["code"] == 0);
}
