// What each step of a decision may take stands in timing.md as the code has it; a decision ends between two
// of its steps, and at its deadline.
#include <catch2/catch.hpp>
#include <string>
#include <variant>

#include "analyzer/deciding.hpp"
#include "analyzer/problem/budgets.hpp"
#include "pal/support/file_system.hpp"
#include "tests/support/skill.hpp"
#include "tests/unit/analyzer/small_skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

std::string with_commas(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

std::string table_of_budgets() {
  std::string table = "| name | at most | of what |\n| --- | --- | --- |\n";
  const auto row = [&table](const char* name, std::size_t number, const char* unit, const char* use) {
    table += "| `" + std::string(name) + "` | " + with_commas(number) + " " + unit + " | " + use + " |\n";
  };
#define PAL_BUDGET(name, number, unit, use) row(#name, number, unit, use);
#include "analyzer/problem/budgets.def"
#undef PAL_BUDGET
  return table;
}

std::string table_of_methods(bool verdicts_only) {
  std::string table = "| method | may find | share of the time |\n| --- | --- | --- |\n";
  for (const DecidingMethod& each : deciding_methods(verdicts_only)) {
    const std::string finds = each.proves && each.refutes ? "holds, fails" : each.proves ? "holds" : "fails";
    table += "| " + std::string(each.name) + " | " + finds + " | " +
             std::to_string(static_cast<int>(each.percent)) + " % |\n";
  }
  return table;
}

/// Neither is decided by its bound: the one holds, the other fails.
std::unique_ptr<test::Skill> two_open() {
  return test::sound_skill(
      test::small_skill("REQUIREMENT answer : RESPONSE FROM tick OF MC1 TO work AT MOST 1 ms\n", test::worker,
                        "PROCESSOR P0\nPLACE SM1 ON P0 PRIORITY 1\nTIME work : 1 TO 2 ms\n"
                        "DEVICE MC1 EVENT tick EVERY 10 ms\n"));
}

}  // namespace

TEST_CASE("timing.md has the budgets and the methods as the code has them") {
  const auto page = DiskFileSystem().read(PAL_SOURCE_DIR "/docs/internals/timing.md");
  const std::string& text = std::get<std::string>(page);
  for (const std::string& table : {table_of_budgets(), table_of_methods(false), table_of_methods(true)}) {
    INFO("docs/internals/timing.md lacks this table:\n" << table);
    CHECK(text.find("\n\n" + table + "\n") != std::string::npos);
  }
}

TEST_CASE("a decision ends between two of its steps once it is told to") {
  const auto skill = two_open();
  const Provers provers{[](const Problem& of, const Options& how) { return analyze_exactly(of, how); }, {}};
  for (const bool told : {false, true}) {
    Analysis analysis = nothing_known(*skill->problem, "Nothing yet.");
    const std::vector<Verdict> bounds = analysis.verdicts;
    Options options;
    options.stop = [told] { return told; };
    decide(deciding_methods(false), OpenCase{provers, *skill->problem, 0, bounds, analysis}, options);
    CHECK(analysis.verdicts.front().state == (told ? VerdictState::undecided : VerdictState::fails));
  }
}

TEST_CASE("each step has its share of the time that is left") {
  Options options;
  options.clock = [] { return 2.0; };
  options.deadline = 12;
  CHECK(share_of(options, 100).deadline == 12);
  CHECK(share_of(options, 25).deadline == 4.5);
  options.deadline = 1;  // over
  CHECK(share_of(options, 50).deadline == 2);
}

TEST_CASE("a limit says what breaks it, which of two values is worse, and by how much a value keeps it") {
  const Limit most{Limit::Sense::at_most, {Figure::Unit::time, 10}};
  const Limit least{Limit::Sense::at_least, {Figure::Unit::time, 10}};
  CHECK_FALSE(most.broken_by(std::int64_t{10}));
  CHECK(most.broken_by(std::int64_t{11}));
  CHECK(most.worse(std::int64_t{4}, std::int64_t{3}));
  CHECK(most.margin(12) == -2);
  CHECK_FALSE(least.broken_by(Duration(10)));
  CHECK(least.broken_by(Duration(9)));
  CHECK(least.worse(Duration(3), Duration(4)));
  CHECK(least.margin(12) == 2);
  Requirement loss;
  loss.measure = Requirement::Measure::loss;
  CHECK(loss.allowed().figure.unit == Figure::Unit::count);
  loss.measure = Requirement::Measure::load;
  CHECK(loss.allowed().figure.unit == Figure::Unit::share);
}
