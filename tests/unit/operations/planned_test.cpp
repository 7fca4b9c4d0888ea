// Skills that are only planned, breakpoints that the file keeps, and cures of findings.
#include <algorithm>

#include "operations/parse.hpp"
#include "operations/skeleton.hpp"
#include "operations/write.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;

namespace {

const std::string planning = test::operation(
    R"({"id": "a", "kind": "planned", "skill": "Insert pin", "note": "Push \"it\" in.", "arguments": {"depth": {"default": 5, "from": 1, "to": 10, "unit": "mm"}}, )"
    R"("codes": [{"code": 0, "text": "It is in."}, {"code": 3, "text": "It does not fit."}], "next": "case", "error": "bad"},)"
    R"({"id": "case", "kind": "case", "ways": [{"codes": [0], "to": "end"}, {"codes": [3], "to": "again"}]},)"
    R"({"id": "again", "kind": "skill", "skill": "wipe", "repeat": 2, "next": "end", "error": "bad", "break": {"value": {"count-of": "a"}, "at-least": 1}},)"
    R"({"id": "end", "kind": "exit"}, {"id": "bad", "kind": "exit", "code": 9})");

const char* const with_parts =
    R"({"operation-format": 1, "name": "o", "icons": [{"id": "start", "kind": "start", "next": "p"},)"
    R"( {"id": "p", "kind": "operation", "operation": "part", "next": "q", "error": "end"},)"
    R"( {"id": "q", "kind": "operation", "operation": "part", "next": "end", "error": "end"}, {"id": "end", "kind": "exit"}],)"
    R"( "operations": [{"name": "part", "icons": [{"id": "start", "kind": "start", "next": "go"},)"
    R"( {"id": "go", "kind": "skill", "skill": "go", "next": "end", "error": "end", "break": {"enabled": false, "every": 2}}, {"id": "end", "kind": "exit"}]}]})";

std::string written(const std::string& text) {
  SourceManager sources;
  Diagnostics diagnostics;
  const auto document = parse(sources, sources.add("o.op.json", text), diagnostics);
  REQUIRE(document);
  REQUIRE_FALSE(diagnostics.has_errors());
  return write(*document);
}

/// The text after all edits of its findings of this code are made, the last in the text first.
std::string cured(const std::string& text, Code code) {
  MemoryFileSystem files;
  files.add("o.op.json", text);
  SourceManager sources;
  Diagnostics diagnostics;
  const auto program = load(files, sources, "o.op.json", diagnostics);
  REQUIRE(program);
  check_shape(*program, diagnostics);
  if (!diagnostics.has_errors()) {
    Cell cell;
    cell.skills.emplace();
    pan::Template go;
    go.name = "go";
    go.completions = {{0, pan::Completion::Kind::normal, 0, "done", {}},
                      {1, pan::Completion::Kind::contingency, 1, "not done", {}}};
    cell.skills->emplace("go", go);
    check_cell(*program, cell, diagnostics);
  }
  std::string result = text;
  for (const Diagnostic& each : diagnostics.all()) {
    if (each.code != code) continue;
    REQUIRE_FALSE(each.fix.empty());
    auto edits = each.fix;
    std::sort(edits.begin(), edits.end(),
              [](const Edit& one, const Edit& other) { return one.where.begin > other.where.begin; });
    for (const Edit& edit : edits)
      result.replace(edit.where.begin, edit.where.end - edit.where.begin, edit.text);
    return result;
  }
  FAIL("there is no such finding");
  return result;
}

}  // namespace

TEST_CASE("a planned skill is a question whose answers are its codes") {
  test::ScriptedRunner runner;
  runner.answers = {1};
  Executor executor(test::program_of(planning), runner);
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(executor.token() == "end");
  CHECK(runner.ran == std::vector<std::string>{"wipe", "wipe"});
  REQUIRE(runner.asked.size() == 1);
  CHECK(runner.asked[0].text == "Insert pin (depth = 5 mm): Push \"it\" in.");
  CHECK(runner.asked[0].answers == std::vector<std::string>{"It is in.", "It does not fit."});
}

TEST_CASE("a planned skill that nobody can do goes to error") {
  test::ScriptedRunner runner;
  runner.nobody = true;
  Executor executor(test::program_of(planning), runner);
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(executor.token() == "bad");
}

TEST_CASE("a planned skill and a breakpoint are written as they are read") {
  CHECK(written(written(planning)) == written(planning));
  CHECK(written(planning).find(R"("break": {"value": {"count-of": "a"}, "at-least": 1},)") !=
        std::string::npos);
  CHECK(written(planning).find(R"({"code": 3, "text": "It does not fit."})") != std::string::npos);
}

TEST_CASE("breakpoints of a file are set on each path") {
  test::ScriptedRunner runner;
  Executor executor(test::program_of(with_parts), runner);
  CHECK(executor.add_kept_breakpoints(100));
  REQUIRE(executor.breakpoints().size() == 2);
  CHECK(executor.breakpoints()[0].icon == "p/go");
  CHECK(executor.breakpoints()[1].icon == "q/go");
  CHECK_FALSE(executor.breakpoints()[0].enabled);
  CHECK(executor.breakpoints()[0].every == 2);
  executor.clear_breakpoints();
  CHECK_FALSE(executor.add_kept_breakpoints(1));
  CHECK(executor.breakpoints().size() == 1);
}

TEST_CASE("a kept breakpoint halts by its condition") {
  test::ScriptedRunner runner;
  runner.answers = {1};
  Executor executor(test::program_of(planning), runner);
  executor.add_kept_breakpoints(100);
  // The planned skill did not end normally, so it is not counted.
  CHECK(executor.run() == ExecutionState::ended);
}

TEST_CASE("a skeleton has the parameters and the codes") {
  const Program program = test::program_of(planning);
  const auto icon = find_icon(program.operations[0], "a");
  REQUIRE(icon);
  const Icon& planned = program.operations[0].icons[*icon];
  CHECK(skeleton_name(planned) == "insert-pin");
  const std::string text = skeleton_of(planned);
  for (const char* part :
       {"SKILL insert-pin\n", "DESCRIPTION \"Push 'it' in.\"",
        "PARAMETER depth : REAL mm DEFAULT 5 RANGE 1 TO 10", "COMPLETION 0 NORMAL \"It is in.\"",
        "COMPLETION 3 CONTINGENCY 1 \"It does not fit.\"", "COMPLETION 4 ERROR"})
    CHECK(text.find(part) != std::string::npos);
}

TEST_CASE("cures make their findings go away") {
  const auto gone = [](const std::string& text, Code code) {
    SourceManager sources;
    Diagnostics diagnostics;
    MemoryFileSystem files;
    files.add("o.op.json", text);
    const auto program = load(files, sources, "o.op.json", diagnostics);
    REQUIRE(program);
    check_shape(*program, diagnostics);
    return std::none_of(diagnostics.all().begin(), diagnostics.all().end(),
                        [&](const Diagnostic& each) { return each.code == code; });
  };
  const std::string nowhere =
      cured(test::operation(R"({"id": "a", "kind": "skill", "skill": "go"})"), Code::PAL1004);
  CHECK(gone(nowhere, Code::PAL1004));
  CHECK(nowhere.find(R"("next": "done")") != std::string::npos);
  const std::string misspelt = cured(
      test::operation(
          R"({"id": "a", "kind": "skill", "skill": "go", "next": "endd"}, {"id": "end", "kind": "exit"})"),
      Code::PAL1004);
  CHECK(misspelt.find(R"("next": "end")") != std::string::npos);
  const std::string started =
      cured(R"({"operation-format": 1, "name": "o", "icons": [{"id": "a", "kind": "exit", "at": [168, 8]}]})",
            Code::PAL1015);
  CHECK(gone(started, Code::PAL1015));
  CHECK(started.find(R"("at": [0, 8])") != std::string::npos);
  const std::string handled = cured(
      test::operation(
          R"({"id": "a", "kind": "skill", "skill": "go", "next": "end"}, {"id": "end", "kind": "exit"})"),
      Code::PAL1006);
  CHECK(handled.find(R"("error": "failed")") != std::string::npos);
  CHECK(handled.find(R"({"id": "failed", "kind": "exit", "code": 1})") != std::string::npos);
}
