// Findings of operations: each is told by its text, of an operation that has it.
#include <string>
#include <vector>

#include "operations/read_log.hpp"
#include "tests/unit/operations/support.hpp"

using namespace pal;

namespace {

struct Written {
  std::string text;
  const char* message;
};

/// A cell with a skill `go` that has a force and a place, and a sensor in N.
operations::Cell cell() {
  operations::Cell result;
  pan::Template go;
  go.name = "go";
  pan::Parameter force;
  force.name = "force";
  force.low = 1;
  force.high = 40;
  pan::Parameter place;
  place.name = "place";
  place.type = pan::ScalarType::text;
  go.parameters = {force, place};
  go.completions = {{0, {}}, {1, {}}};
  result.skills = operations::Skills{{"go", go}};
  result.sensors = operations::Sensors{{"scale", {"N", "", {}}}};
  result.unable = {{"go", "it has no gripper"}};
  return result;
}

void expect_findings(const std::vector<Written>& list) {
  for (const Written& written : list) {
    MemoryFileSystem files;
    files.add("o.op.json", written.text);
    files.add("none.op.json", "[]");
    SourceManager sources;
    Diagnostics diagnostics;
    const auto program = operations::load(files, sources, "o.op.json", diagnostics);
    if (program) operations::check_shape(*program, diagnostics);
    if (program && !diagnostics.has_errors()) operations::check_cell(*program, cell(), diagnostics);
    std::string found;
    for (const Diagnostic& each : diagnostics.all()) found += each.message + "\n";
    CAPTURE(written.text, found, written.message);
    CHECK(found.find(std::string(written.message) + "\n") != std::string::npos);
  }
}

/// An operation with one icon `a` between START and EXIT, of these fields.
std::string icon(const std::string& fields, const std::string& more = "") {
  return test::operation(R"({"id": "a", )" + fields + R"(, "next": "end"}, {"id": "end", "kind": "exit"})",
                         more);
}

std::string question(const std::string& answers) {
  return test::operation(R"({"id": "a", "kind": "question", "text": "?", "answers": [)" + answers +
                         R"(]}, {"id": "end", "kind": "exit"})");
}

std::string branch(const std::string& ways) {
  return test::operation(R"({"id": "a", "kind": "case", "ways": [)" + ways +
                         R"(]}, {"id": "end", "kind": "exit"})");
}

std::string planned(const std::string& codes) {
  return icon(R"("kind": "planned", "skill": "new", "codes": [)" + codes + "]");
}

std::string repeated(const std::string& text, int count) {
  std::string result = text;
  for (int i = 1; i < count; ++i) result += ", " + text;
  return result;
}

}  // namespace

TEST_CASE("wrong fields of an operation are told") {
  const std::string go = R"("kind": "skill", "skill": "go")";
  const auto with = [](const std::string& arguments) {
    return test::operation(R"({"id": "a", "kind": "exit"})", R"(, "arguments": )" + arguments);
  };
  expect_findings({
      {"[]", "an operation is an object"},
      {R"({"operation-format": 2, "name": "o", "icons": []})", "this program reads operation-format 1 only"},
      {icon(go, R"(, "operations": [1])"), "a sub-operation is an object"},
      {icon(go + R"(, "parameters": {"force": [1]})"),
       "a parameter is a number, true, false, a text, a count, an argument or an output"},
      {icon(go + R"(, "operator": {"force": 1})"), "what an operator may set is an object"},
      {icon(go + R"(, "operator": {"force": {"from": 5, "to": 2.5}})"), "from 5 to 2.5 runs backwards"},
      {with(R"({"x": 1})"), "an argument is an object"},
      {with(R"({"x": {"default": ")" + std::string(101, 'a') + R"("}})"), "a text has at most 100 signs"},
      {with(R"({"x": {"default": [1]}})"), "a default is a number, a text, true or false"},
      {with(R"({"x": {"default": 1.5, "from": 1, "to": 2, "whole": true}})"),
       "the default of 'x' is not a whole number"},
      {with(R"({"x": {"default": 3, "from": 1, "to": 2}})"), "the default of 'x' is not in its range"},
      {branch(R"({"codes": [0], "to": "end"})"), "a CASE has two to four ways, this one has 1"},
      {branch(repeated(R"({"codes": [0], "to": "end"})", 5)), "a CASE has two to four ways, this one has 5"},
      {question(""), "a question has one to six answers, this one has 0"},
      {question(repeated(R"({"text": "Yes", "to": "end"})", 7)),
       "a question has one to six answers, this one has 7"},
      {question("1"), "an answer is an object"},
      {planned("1"), "a code of a planned skill is an object"},
      {planned(repeated(R"({"code": 0, "text": "It is done."})", 2)),
       "this code, or its text, is given twice"},
      {planned(""), "a planned skill has one to 8 codes, this one has 0"},
  });
}

TEST_CASE("wrong fields of a test are told") {
  const std::string test = R"("kind": "test", "sensor": "scale")";
  expect_findings({
      {icon(test + R"(, "limits": [1, 2, 3, 4])"), "a test has one to three limits, this one has 4"},
      {icon(test + R"(, "limits": [1], "at-least": 2)"), "a test has limits, or 'at-least' and 'at-most'"},
      {icon(test + R"(, "value": {"count-of": "a"}, "at-least": 2)"), "either a sensor is read or a value"},
      {icon(R"("kind": "test", "value": {"count-of": "a"}, "mean-of": 2, "at-least": 2)"),
       "only a sensor is read more than once"},
      {icon(R"("kind": "test", "all": [1, 2])"), "a condition is an object"},
  });
}

TEST_CASE("wrong lines of an operation are told") {
  expect_findings({
      {test::operation(R"({"id": "a", "kind": "delay", "seconds": 1})"),
       "the output next of 'a' leads nowhere"},
      {test::operation(R"({"id": "a", "kind": "delay", "seconds": 1, "next": "start"})"),
       "START has no input"},
      {icon(R"("kind": "delay", "seconds": {"count-of": "end"})"),
       "operation 'o' has no skill or sub-operation 'end' to count"},
      {icon(R"("kind": "delay", "seconds": {"output-of": "end", "name": "x"})"),
       "operation 'o' has no skill 'end'"},
      {test::operation(R"({"id": "a", "kind": "start", "next": "end"}, {"id": "end", "kind": "exit"})"),
       "operation 'o' has a second START"},
      {test::operation(R"({"id": "on-stop", "kind": "exit"})"), "no icon can be called 'on-stop'"},
      {icon(R"("kind": "operation", "file": "none.op.json")"), "'none.op.json' holds no operation"},
  });
}

TEST_CASE("what does not fit the cell is told") {
  const std::string go = R"("kind": "skill", "skill": "go")";
  expect_findings({
      {icon(go), "the cell cannot run skill 'go': it has no gripper"},
      {icon(go + R"(, "operator": {"speed": {}})"),
       "skill 'go' has no parameter 'speed', which an operator may set"},
      {icon(go + R"(, "operator": {"place": {"from": 1}})"),
       "'place' is no number, so it has no range for an operator"},
      {icon(go + R"(, "operator": {"force": {"from": 0.5}})"),
       "an operator may set 'force' beyond what skill 'go' allows: 1 to 40"},
      {icon(R"("kind": "wait", "sensor": "scale", "at-least": {"argument": "x"})",
            R"(, "arguments": {"x": {"default": 1, "from": 1, "to": 2}})"),
       "{argument} is a plain number, and the sensor is in N"},
      {test::operation(
           R"({"id": "a", "kind": "skill", "skill": "go", "next": "c", "error": "c"},)"
           R"({"id": "c", "kind": "case", "ways": [{"codes": [0], "to": "end"}, {"codes": [7], "to":)"
           R"( "end"}]}, {"id": "end", "kind": "exit"})"),
       "code 7 never comes to CASE 'c'"},
  });
}

TEST_CASE("a log of something else is told") {
  const auto program = test::program_of(test::operation(test::looping));
  const auto told = [&](const std::string& line) {
    SourceManager sources;
    Diagnostics diagnostics;
    operations::read_log(sources, sources.add("log", line), program, diagnostics);
    return diagnostics.all().empty() ? "" : diagnostics.all().front().message;
  };
  CHECK(told("no log\n") == "this line is no step of an operation");
  CHECK(told(R"({"step":1,"icon":"a","skill":"back","parameters":{},"kind":"normal","code":0,"reason":"",)"
             R"("begin_s":0,"end_s":1})"
             "\n") == "icon 'a' of the operation does something else");
}
