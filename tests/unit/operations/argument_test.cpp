// Arguments of sub-operations, figures that skills report, and counts, wherever a number may stand.
#include "operations/check.hpp"
#include "operations/codes.hpp"
#include "operations/graph.hpp"
#include "operations/ways.hpp"
#include "operations/write.hpp"
#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;
using namespace std::chrono_literals;
using test::operation;
using test::program_of;

namespace {

/// The operation `p` presses with its argument, for as long as its other one says.
std::string pressing(const std::string& parameters,
                     const std::string& argument = R"({"default": 5, "from": 1, "to": 40, "unit": "N"})") {
  return operation(
      R"({"id": "a", "kind": "operation", "operation": "p", "parameters": {)" + parameters +
          R"(}, "next": "end", "error": "bad"}, {"id": "end", "kind": "exit"}, {"id": "bad", "kind": "exit", "code": 5})",
      R"(, "operations": [{"name": "p", "arguments": {"hard": )" + argument +
          R"(, "long": {"default": 2, "from": 0, "to": 10, "unit": "s"}, "place": {"default": "HOME"}}, "icons": [)"
          R"({"id": "start", "kind": "start", "next": "x"},)"
          R"({"id": "x", "kind": "skill", "skill": "press", "parameters": {"force": {"argument": "hard"}}, "next": "d", "error": "done"},)"
          R"({"id": "d", "kind": "delay", "seconds": {"argument": "long"}, "next": "g"},)"
          R"({"id": "g", "kind": "skill", "skill": "move", "parameters": {"location": {"argument": "place"}}, "next": "done", "error": "done"},)"
          R"({"id": "done", "kind": "exit"}]}])");
}

Cell pressing_cell() {
  Cell cell;
  Skills& skills = cell.skills.emplace();
  pan::Parameter force, location;
  force.name = "force";
  force.unit = "N";
  force.low = 1;
  force.high = 40;
  location.name = "location";
  location.type = pan::ScalarType::text;
  location.location = true;
  location.default_text = "HOME";
  skills["press"].name = "press";
  skills["press"].parameters = {force};
  skills["press"].completions.resize(1);
  skills["move"].name = "move";
  skills["move"].parameters = {location};
  skills["move"].completions.resize(1);
  cell.locations = {"HOME", "PART"};
  return cell;
}

/// The messages of all errors.
std::string errors_of(const std::string& text, const Cell& cell = pressing_cell()) {
  MemoryFileSystem files;
  files.add("o.op.json", text);
  SourceManager sources;
  Diagnostics diagnostics;
  const auto program = load(files, sources, "o.op.json", diagnostics);
  if (program && !diagnostics.has_errors()) check_shape(*program, diagnostics);
  if (program && !diagnostics.has_errors()) check_cell(*program, cell, diagnostics);
  std::string result;
  for (const Diagnostic& each : diagnostics.sorted())
    if (each.severity == Severity::error) result += each.message + "\n";
  return result;
}

double number(const test::ScriptedRunner& runner) {
  return std::get<double>(runner.last_parameters.at(0).value);
}

}  // namespace

TEST_CASE("an operation gets its arguments, or their defaults") {
  test::ScriptedRunner runner;
  std::vector<double> forces;
  std::string place;
  runner.during = [&] {
    if (runner.ran.back() == "press") forces.push_back(number(runner));
    if (runner.ran.back() == "move") place = std::get<std::string>(runner.last_parameters.at(0).value);
  };
  Executor given(program_of(pressing(R"("hard": 12, "long": 0.5, "place": "PART")")), runner);
  CHECK(given.run() == ExecutionState::ended);
  CHECK(place == "PART");
  CHECK(runner.now() == 2500ms);
  Executor usual(program_of(pressing("")), runner);
  CHECK(usual.run() == ExecutionState::ended);
  CHECK(place == "HOME");
  CHECK(runner.now() == 6500ms);
  CHECK(forces == std::vector<double>{12, 5});
  SECTION("also if it begins in the middle") {
    Executor middle(program_of(pressing(R"("hard": 7)")), runner);
    middle.start_from("a/x");
    CHECK(middle.run() == ExecutionState::ended);
    CHECK(forces.back() == 7);
  }
  SECTION("and by hand") {
    const Cell cell = pressing_cell();
    Executor changed(program_of(pressing("")), runner, nullptr, &cell);
    changed.set_parameter("a", "hard", 30.0);
    CHECK_THROWS_WITH(changed.set_parameter("a", "hard", 41.0),
                      "'hard' of operation 'p' cannot be 41; write a number from 1 to 40 N");
    CHECK_THROWS_AS(changed.set_parameter("a", "soft", 1.0), ExecutionError);
    CHECK_THROWS_WITH(changed.set_parameter("a/g", "location", std::string("NOWHERE")),
                      Catch::Contains("location 'NOWHERE' is not taught"));
    CHECK(changed.run() == ExecutionState::ended);
    CHECK(forces.back() == 30);
  }
}

TEST_CASE("arguments are checked in name, type, range and unit") {
  CHECK(errors_of(pressing(R"("hard": 12)")).empty());
  CHECK(errors_of(pressing(R"("soft": 12)")) == "operation 'p' has no argument 'soft'\n");
  CHECK(errors_of(pressing(R"("hard": 41)")) == "'hard' of operation 'p' cannot be 41\n");
  CHECK(errors_of(pressing(R"("hard": "much")")) == "'hard' of operation 'p' cannot be \"much\"\n");
  CHECK(errors_of(pressing(R"("place": "NOWHERE")")) == "location 'NOWHERE' is not taught\n");
  CHECK(errors_of(pressing("", R"({"default": 5, "from": 1, "to": 50, "unit": "N"})")) ==
        "'force' of skill 'press' cannot be the argument hard, which is a number from 1 to 50 N\n");
  CHECK(errors_of(pressing("", R"({"default": 5, "from": 1, "to": 40, "unit": "mm"})")) ==
        "'force' of skill 'press' cannot be the argument hard, which is a number from 1 to 40 mm\n");
  CHECK(errors_of(pressing("", R"({"default": "HOME"})")) ==
        "'force' of skill 'press' cannot be the argument hard, which is a text in double quotes\n");
  CHECK(errors_of(pressing("", R"({"default": 50, "from": 1, "to": 40, "unit": "N"})")) ==
        "the default of 'hard' is not in its range\n");
  CHECK(
      errors_of(operation(
          R"({"id": "a", "kind": "delay", "seconds": {"argument": "x"}, "next": "end"}, {"id": "end", "kind": "exit"})")) ==
      "operation 'o' has no argument 'x'\n");
}

TEST_CASE(
    "the skill itself is asked whether it refuses values together, if all of them are known and allowed") {
  Cell cell = pressing_cell();
  std::vector<std::string> asked;
  cell.refused_together = [&](const std::string& skill,
                              const std::vector<Parameter>& given) -> std::optional<std::string> {
    const double force = std::get<double>(given.at(0).value);
    asked.push_back(skill + " " + given.at(0).name);
    if (force < 30) return std::nullopt;
    return "force is too great for this tool";
  };
  const auto with = [](const std::string& parameters) {
    return operation(
        R"({"id": "a", "kind": "skill", "skill": "press", "parameters": )" + parameters +
        R"(, "next": "end", "error": "bad"}, {"id": "end", "kind": "exit"}, {"id": "bad", "kind": "exit", "code": 5})");
  };
  CHECK(errors_of(with(R"({"force": 20})"), cell).empty());
  CHECK(errors_of(with(R"({"force": 35})"), cell) ==
        "skill 'press' refuses these values together: force is too great for this tool\n");
  CHECK(asked == std::vector<std::string>{"press force", "press force"});
  // A value that is refused by itself is one finding; defaults alone are the skill's own.
  CHECK(errors_of(with(R"({"force": 50})"), cell).find("together") == std::string::npos);
  CHECK(errors_of(with("{}"), cell).empty());
  // What an argument will be is not known yet.
  CHECK(errors_of(pressing(R"("hard": 35)"), cell).empty());
  CHECK(asked.size() == 2);
}

TEST_CASE("a refused value is one finding") {
  const auto icon = [](const std::string& fields) {
    return operation(R"({"id": "a", )" + fields + R"(}, {"id": "end", "kind": "exit"})");
  };
  for (
      const std::string fields :
      {R"("kind": "delay", "seconds": "5", "next": "end")",
       R"("kind": "delay", "seconds": -5, "next": "end")", R"("kind": "skill", "skill": 7, "next": "end")",
       R"("kind": "test", "sensor": 7, "limits": [1], "next": "end")",
       R"("kind": "test", "sensor": "eye", "limits": "1", "next": "end")",
       R"("kind": "wait", "sensor": "eye", "at-least": "1", "next": "end")",
       R"("kind": "wait", "sensor": "eye", "at-most": "1", "next": "end")",
       R"("kind": "wait", "sensor": "eye", "at-least": {"count": "a"}, "next": "end")",
       R"("kind": "case", "ways": 7, "default": "end")",
       R"("kind": "case", "ways": [{"codes": ["x"], "to": "end"}], "default": "end")",
       R"("kind": "question", "text": 3, "answers": [{"text": "Yes", "to": "end"}])",
       R"("kind": "skill", "skill": "press", "retries": "x", "retry-on": [1], "next": "end")",
       R"("kind": "skill", "skill": "move", "parameters": {"location": 5}, "next": "end")",
       R"("kind": "skill", "skill": "move", "parameters": {"location": "a place with too long a name"}, "next": "end")"}) {
    INFO(fields << "\n" << errors_of(icon(fields)));
    const std::string errors = errors_of(icon(fields));
    CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
  }
}

TEST_CASE("what a skill reports is a parameter, a limit and a condition") {
  const std::string text = operation(
      R"({"id": "a", "kind": "skill", "skill": "find", "next": "t", "error": "end"},)"
      R"({"id": "t", "kind": "test", "value": {"output-of": "a", "name": "force"}, "limits": [10], "next": "c", "error": "bad"},)"
      R"({"id": "c", "kind": "case", "ways": [{"codes": [0], "to": "end"}, {"codes": [1], "to": "b"}]},)"
      R"({"id": "b", "kind": "skill", "skill": "press", "parameters": {"force": {"output-of": "a", "name": "force"}}, "next": "end", "error": "bad"},)"
      R"({"id": "end", "kind": "exit"}, {"id": "bad", "kind": "exit", "code": 5})");
  test::ScriptedRunner runner;
  runner.figures = {{"force", 12.5}};
  Executor executor(program_of(text), runner);
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(runner.ran == std::vector<std::string>{"find", "press"});
  CHECK(number(runner) == 12.5);
  runner.figures = {{"force", 9}};
  executor.start_from("start");
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(runner.ran.size() == 3);
  SECTION("a missing one ends the icon with a code of its own") {
    executor.start_from("b");
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(executor.token() == "bad");
    runner.figures.clear();
    executor.start_from("start");
    CHECK(executor.run() == ExecutionState::ended);
    CHECK(executor.token() == "bad");
  }
  SECTION("it must be known to the cell") {
    Cell cell = pressing_cell();
    (*cell.skills)["find"].completions.resize(1);
    cell.figures = Sensors{{"force", {"N", ""}}};
    Diagnostics good, bad;
    check_cell(program_of(text), cell, good);
    CHECK_FALSE(good.has_errors());
    cell.figures = Sensors{{"strength", {"N", ""}}};
    check_cell(program_of(text), cell, bad);
    CHECK(bad.errors() == 2);
  }
}

TEST_CASE("a count is a limit, a delay, and the code of an exit") {
  const auto program = program_of(operation(
      R"({"id": "a", "kind": "skill", "skill": "go", "next": "d", "error": "end"},)"
      R"({"id": "d", "kind": "delay", "seconds": {"count-of": "a"}, "next": "t"},)"
      R"({"id": "t", "kind": "test", "value": {"count-of": "a"}, "limits": [3], "next": "c"},)"
      R"({"id": "c", "kind": "case", "ways": [{"codes": [0], "to": "a"}, {"codes": [1], "to": "end"}]},)"
      R"({"id": "end", "kind": "exit", "code": {"count-of": "a"}})"));
  test::ScriptedRunner runner;
  Executor executor(program, runner);
  CHECK(executor.run() == ExecutionState::ended);
  CHECK(executor.last_code() == 3);
  CHECK(runner.now() == 3s + 1s + 2s + 3s);
  const auto codes = possible_codes(Graph(program), {});
  CHECK(codes.exits[0].list() == std::vector<int>{any_code});
}

TEST_CASE("a CASE behind a count needs a default") {
  const auto text = [](const std::string& more) {
    return operation(
        R"({"id": "a", "kind": "operation", "operation": "p", "next": "c"},)"
        R"({"id": "c", "kind": "case", "ways": [{"codes": [1], "to": "end"}, {"codes": [2], "to": "end"}])" +
            more + R"(}, {"id": "end", "kind": "exit"})",
        R"(, "operations": [{"name": "p", "icons": [{"id": "start", "kind": "start", "next": "x"},)"
        R"({"id": "x", "kind": "skill", "skill": "press", "next": "done", "error": "done"},)"
        R"({"id": "done", "kind": "exit", "code": {"count-of": "x"}}]}])");
  };
  Diagnostics with, without;
  check_cell(program_of(text(R"(, "default": "end")")), pressing_cell(), with);
  CHECK(with.all().empty());
  check_cell(program_of(text("")), pressing_cell(), without);
  REQUIRE(without.all().size() == 1);
  CHECK(without.all()[0].message == "CASE 'c' has no way for any other code, which can come");
  CHECK(ways_through(program_of(text(R"(, "default": "end")")), *pressing_cell().skills, {}).ways.size() ==
        3);
}
