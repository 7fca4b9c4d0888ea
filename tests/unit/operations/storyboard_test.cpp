#include "operations/storyboard.hpp"

#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;

TEST_CASE("a storyboard tells scenes, and branches by code") {
  Skills skills;
  pan::Completion done, none;
  done.description = "It is there.";
  none.code = 1;
  none.kind = pan::Completion::Kind::contingency;
  none.description = "The way <was> shut.";
  skills["go"].descriptions = {"Goes there."};
  skills["go"].preconditions = {"The way is free."};
  skills["go"].postconditions = {"It stands still."};
  skills["go"].completions = {done, none};
  const auto program = test::program_of(test::operation(test::looping));
  CHECK(storyboard_markdown(program, skills) ==
        "# o\n\nIt begins with scene 1, a.\n\n### Scene 1: a\n\nBefore: The way is free.\n\n"
        "The skill go runs with far 3: it goes there.\n\nAfterwards, if the code is normal: It stands "
        "still.\n\n"
        "- Code 0: It is there. The story goes on with scene 2, b.\n"
        "- Code 1: The way \\<was\\> shut. The story goes on with scene 1, a.\n\n"
        "### Scene 2: b\n\nThe skill back runs. Nothing is known of it.\n\n"
        "- Code 0. The operation ends at end with code 0.\n");
  const std::string page = storyboard_html(program, skills);
  CHECK(page.find("The way &lt;was&gt; shut") != std::string::npos);
  CHECK(page.find("<svg") != std::string::npos);
  CHECK(page.find("<?xml") == std::string::npos);
}

TEST_CASE("a storyboard tells a run, scene by scene") {
  const auto program = test::program_of(test::operation(test::looping));
  using Kind = SkillResult::Kind;
  using namespace std::chrono_literals;
  const std::vector<Step> steps{
      {1, "a", "go", {}, {Kind::contingency, 1, "The way was shut."}, 500ms, 1500ms},
      {2, "a", "go", {}, {Kind::stopped, 9, "stopped on request"}, 2s, 2250ms},
      {3, "a", "go", {}, {Kind::normal, 0, "There."}, 3s, 6s}};
  const Happened run(program, steps);
  const std::string story = storyboard_markdown(program, {}, &run);
  INFO(story);
  for (const char* sentence :
       {"The run had 3 steps, from 0.50 s to 6.00 s of the cell's time: 5.50 s.",
        "1. At 0.50 s a (go) began, took 1.00 s and ended with code 1: The way was shut.",
        "In the run it began 3 times, first at 0.50 s; it took 0.25 to 3.00 s; code 0 once, code 1 once, cut "
        "off once.",
        "In the run the token did not come here."})
    CHECK(story.find(sentence) != std::string::npos);
  CHECK(to_dot(program, 0, &run).find("3×") != std::string::npos);
  CHECK(to_dot(program, 0).find("×") == std::string::npos);
}

TEST_CASE("the longest run is told by its first steps") {
  const auto program = test::program_of(test::operation(test::looping));
  std::vector<Step> steps(10'000, Step{1, "a", "go", {}, {}, {}, {}});
  const auto course = Happened(program, steps).course();
  CHECK(course.size() == 51);
  CHECK(course.back() == "9950 more steps followed.");
}

TEST_CASE("a storyboard tells a sub-operation by its exits, and a count in words") {
  const auto program = test::program_of(R"({
  "operation-format": 1,
  "name": "o",
  "icons": [
    {"id": "start", "kind": "start", "next": "inner"},
    {"id": "inner", "kind": "operation", "operation": "s", "next": "rest", "error": "end"},
    {"id": "rest", "kind": "delay", "seconds": 2, "next": "end"},
    {"id": "end", "kind": "exit"}
  ],
  "operations": [
    {
      "name": "s",
      "description": "Puts one down.",
      "icons": [
        {"id": "start", "kind": "start", "next": "put"},
        {"id": "put", "kind": "skill", "skill": "put", "parameters": {"angle": 90, "placed": {"count-of": "put"}}, "next": "done", "error": "given-up"},
        {"id": "done", "kind": "exit", "code": 0},
        {"id": "given-up", "kind": "exit"}
      ]
    }
  ]
})");
  Skills skills;
  skills["put"].parameters.resize(2);
  skills["put"].parameters[0].name = "angle";
  skills["put"].parameters[0].unit = "deg";
  skills["put"].parameters[1].name = "placed";
  skills["put"].completions.resize(2);
  skills["put"].completions[1].code = 3;
  skills["put"].completions[1].kind = pan::Completion::Kind::error;
  const std::string story = storyboard_markdown(program, skills);
  INFO(story);
  for (const char* sentence :
       {"The operation s runs: it puts one down. Its own scenes are told below.",
        "- Code 0, from its exit done. The story goes on with scene 2, rest.",
        "- Code 3, from its exit given-up. The operation ends at end with code 3.",
        "\n- The operation ends at end with code 0.\n",
        "The skill put runs with angle 90 degrees and placed equal to the count of put so far"})
    CHECK(story.find(sentence) != std::string::npos);
}
