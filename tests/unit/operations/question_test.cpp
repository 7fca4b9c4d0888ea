// A question to a person, whose answers are ways.
#include <sstream>

#include "operations/step_log.hpp"
#include "operations/storyboard.hpp"
#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;
using namespace std::chrono_literals;

namespace {

const std::string asking = test::operation(
    R"({"id": "a", "kind": "question", "text": "Is it clean?", "answers": [{"text": "Yes", "to": "end"}, {"text": "No", "to": "again"}], "timeout": 60, "error": "nobody"},)"
    R"({"id": "again", "kind": "skill", "skill": "wipe", "next": "a", "error": "nobody"},)"
    R"({"id": "end", "kind": "exit"}, {"id": "nobody", "kind": "exit", "code": 3})");

}  // namespace

TEST_CASE("answers are ways") {
  test::ScriptedRunner runner;
  runner.answers = {1, std::nullopt, 0};
  std::ostringstream out;
  StepLog log(out);
  Executor executor(test::program_of(asking), runner, &log);
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(executor.token() == "end");
  CHECK(runner.ran == std::vector<std::string>{"wipe"});
  REQUIRE(runner.asked.size() == 2);
  CHECK(runner.asked[0].icon == "a");
  CHECK(runner.asked[0].text == "Is it clean?");
  CHECK(runner.asked[0].answers == std::vector<std::string>{"Yes", "No"});
  CHECK(runner.withdrawn == 2);
  const auto step = parse_log_line(out.str().substr(0, out.str().find('\n')));
  REQUIRE(step);
  CHECK(step->question == "Is it clean?");
  CHECK(step->answer == "No");
  CHECK(step->result.code == 1);
  CHECK(step->has_code());
  CHECK(log_line(*step) + "\n" == out.str().substr(0, out.str().find('\n') + 1));
}

TEST_CASE("a question that nobody answers goes to error") {
  test::ScriptedRunner runner;
  SECTION("in time") {
    Executor executor(test::program_of(asking), runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(executor.token() == "nobody");
    CHECK(runner.now() >= 60s);
    CHECK(runner.now() < 61s);
  }
  SECTION("since nobody is there") {
    runner.nobody = true;
    Executor executor(test::program_of(asking), runner);
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(executor.token() == "nobody");
    CHECK(runner.now() == 0s);
  }
  CHECK(runner.withdrawn == 1);
}

TEST_CASE("a pause and a stop withdraw a question, which is asked again") {
  const bool stop = GENERATE(true, false);
  test::ScriptedRunner runner;
  Executor executor(test::program_of(asking), runner);
  runner.during_delay = [&] { stop ? executor.stop() : executor.pause(); };
  CHECK(executor.run() == (stop ? ExecutionState::stopped : ExecutionState::paused));
  CHECK(executor.token() == "a");
  CHECK(runner.withdrawn == 1);
  runner.during_delay = nullptr;
  runner.answers = {0};
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(executor.token() == "end");
  CHECK(runner.asked.size() == 2);
}

TEST_CASE("a story tells a question and its answers") {
  const auto program = test::program_of(asking);
  const std::string story = storyboard_markdown(program, {});
  INFO(story);
  for (const char* sentence : {"A person is asked: \"Is it clean?\"; it waits 60 s at most.",
                               "- Code 0: The answer is \"Yes\". The operation ends at end with code 0.",
                               "- Code 1: The answer is \"No\". The story goes on with scene 2, again.",
                               "- Code -2: The time is over. The operation ends at nobody with code 3.",
                               "- Code -1: Nobody can be asked. The operation ends at nobody with code 3."})
    CHECK(story.find(sentence) != std::string::npos);
  CHECK(to_dot(program, 0).find("label=\"Yes\"") != std::string::npos);
}
