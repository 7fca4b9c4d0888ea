// Formulas of the longest times, and times that are declared by them.
#include "operations/formula.hpp"

#include "operations/icon_times.hpp"
#include "operations/ways.hpp"
#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;
using namespace std::chrono_literals;

namespace {

std::optional<ValueRange> over(const std::string& text, const std::map<std::string, ValueRange>& known = {}) {
  const auto formula = Formula::parse(text);
  if (!formula) return std::nullopt;
  return formula->over([&](const std::string& name) -> std::optional<ValueRange> {
    const auto found = known.find(name);
    return found == known.end() ? std::nullopt : std::optional(found->second);
  });
}

pan::Parameter number(const std::string& name, double low, double high, double usual) {
  pan::Parameter parameter;
  parameter.name = name;
  parameter.low = low;
  parameter.high = high;
  parameter.default_value = usual;
  return parameter;
}

Skills with_touch() {
  Skills skills;
  pan::Template& touch = skills["touch"];
  touch.name = "touch";
  touch.parameters = {number("reach", 1, 300, 60), number("approach-speed", 1, 60, 20)};
  pan::Completion done, none;
  none.code = 1;
  none.kind = pan::Completion::Kind::contingency;
  touch.completions = {done, none};
  return skills;
}

DeclaredTimes declared() {
  return {{{"touch", 0}, *Formula::parse("reach / approach-speed + 2")},
          {{"touch", 1}, *Formula::parse("2 * reach / approach-speed + 2")}};
}

std::string touch(const std::string& parameters) {
  return test::operation(R"({"id": "a", "kind": "skill", "skill": "touch", "parameters": {)" + parameters +
                         R"(}, "next": "end", "error": "end"}, {"id": "end", "kind": "exit"})");
}

}  // namespace

TEST_CASE("a formula has the usual order, and names with hyphens") {
  CHECK(over("1 + 2 * 3")->high == 7);
  CHECK(over("(1 + 2) * 3 - 4 / 2")->high == 7);
  CHECK(over("2 * way-1 / 4", {{"way-1", {6, 6}}})->high == 3);
  CHECK(over("norm(dx, 4) + max(1, abs(dx), 2)", {{"dx", {-3, -3}}})->high == 8);
}

TEST_CASE("what is no formula is none") {
  for (const char* wrong :
       {"", "1 +", "(1", "1)", "a b", "a-", "abs(1, 2)", "root(1)", "1 ** 2", "-1", "max()"})
    CHECK_FALSE(Formula::parse(wrong));
  CHECK_FALSE(Formula::parse(std::string(1000, '(') + "1" + std::string(1000, ')')));
}

TEST_CASE("a formula contains all values of its names") {
  const std::map<std::string, ValueRange> known{{"a", {-2, 3}}, {"b", {1, 4}}};
  const auto expect = [&](const char* text, double low, double high) {
    INFO(text);
    const auto all = over(text, known);
    REQUIRE(all);
    CHECK(all->low == low);
    CHECK(all->high == high);
  };
  expect("a + b", -1, 7);
  expect("a - b", -6, 2);
  expect("a * b", -8, 12);
  expect("a / b", -2, 3);
  expect("abs(a)", 0, 3);
  expect("max(a, b)", 1, 4);
  expect("norm(a, 4)", 4, 5);
  CHECK_FALSE(over("1 / a", known));
  CHECK_FALSE(over("c", known));
}

TEST_CASE("the longest time is declared by an icon's parameters") {
  const auto ways = [](const std::string& text) {
    return ways_through(test::program_of(text), with_touch(), {{}, declared()}).ways;
  };
  const auto usual = ways(touch(""));
  REQUIRE(usual.size() == 2);
  CHECK(usual[0].longest == Duration(5s));
  CHECK(usual[1].longest == Duration(8s));
  CHECK(usual[0].declared);
  CHECK(ways(touch(R"("reach": 100, "approach-speed": 10)"))[0].longest == Duration(12s));
  // Known when it runs: as long as it may take.
  CHECK(ways(touch(R"("reach": {"count-of": "a"})"))[0].longest == Duration(17s));
}

TEST_CASE("what is proved goes before what is declared, and a limit before both") {
  const auto program = test::program_of(touch(""));
  const SkillTimes times{{{{"touch", 0}, 3s}}, declared()};
  const auto ways = ways_through(program, with_touch(), times).ways;
  CHECK(ways[0].longest == Duration(3s));
  CHECK_FALSE(ways[0].declared);
  CHECK(ways[1].declared);
  const auto icons = icon_times(program, with_touch(), times);
  REQUIRE(icons.size() == 1);
  CHECK(icons[0].longest == Duration(8s));
  CHECK(icons[0].declared);
}
