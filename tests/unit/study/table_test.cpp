#include "study/table.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "study/plots.hpp"

using namespace pal::study;

namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

/// Two figures of 2 and 3 values, one skill, one requirement: it holds, fails, is undecided, never, not
/// checked.
Table table_of_two() {
  Table table;
  table.study.title = "a \"study\" | with, marks";
  table.study.figures = {{"period", {{"5 ms", {}}, {"10 ms", {}}}, 0},
                         {"who, first", {{"a", {}}, {"b", {}}, {"c", {}}}, 0}};
  table.study.plots = {{{0}}, {{0, 1}}};
  table.pairs = {{"skill", "cell"}};
  table.requirements = {"soon"};
  table.notes = {"", "PAL0708: the period, \"0\""};
  const Outcome outcomes[] = {Outcome::holds, Outcome::fails,       Outcome::undecided,
                              Outcome::never, Outcome::not_checked, Outcome::holds};
  for (std::uint32_t point = 0; point < 6; ++point) {
    Row row;
    row.point = point;
    row.outcome = outcomes[point];
    row.measure = pal::analyzer::Requirement::Measure::response;
    row.described = true;
    row.limit = 9'000'000;
    if (row.outcome == Outcome::holds) row.bound = 7'000'000 + point;
    if (row.outcome == Outcome::fails) row.bound = row.attained = 12'000'000;
    row.note = row.outcome == Outcome::not_checked ? 1 : 0;
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace

TEST_CASE("a table as CSV") {
  std::ostringstream out;
  write_csv(table_of_two(), out);
  CHECK(out.str() ==
        "point,skill,environment,period,\"who, "
        "first\",requirement,measure,verdict,limit_ns,bound_ns,attained_ns,"
        "slack_ns,exact,note\n"
        "0,skill,cell,5 ms,a,soon,response,holds,9000000,7000000,,2000000,false,\n"
        "1,skill,cell,5 ms,b,soon,response,fails,9000000,12000000,12000000,-3000000,false,\n"
        "2,skill,cell,5 ms,c,soon,response,undecided,9000000,,,,false,\n"
        "3,skill,cell,10 ms,a,soon,response,never,9000000,,,,false,\n"
        "4,skill,cell,10 ms,b,soon,response,not checked,9000000,,,,false,\"PAL0708: the period, \"\"0\"\"\"\n"
        "5,skill,cell,10 ms,c,soon,response,holds,9000000,7000005,,1999995,false,\n");
}

TEST_CASE("a table as JSON says the same") {
  std::ostringstream out;
  write_json(table_of_two(), out);
  const auto document = nlohmann::json::parse(out.str());
  CHECK(document.at("title") == "a \"study\" | with, marks");
  CHECK(document.at("figures").at(1).at("values") == nlohmann::json::array({"a", "b", "c"}));
  REQUIRE(document.at("rows").size() == 6);
  CHECK(document.at("rows").at(1).at("slack_ns") == -3'000'000);
  CHECK(document.at("rows").at(2).at("bound_ns").is_null());
  CHECK(document.at("rows").at(4).at("verdict") == "not checked");
  CHECK(document.at("rows").at(4).at("note") == "PAL0708: the period, \"0\"");
  CHECK(document.at("rows").at(5).at("values") == nlohmann::json::array({"10 ms", "c"}));
}

TEST_CASE("a summary counts proofs by their worst verdict, and nothing that is not proved as good") {
  std::ostringstream out;
  write_summary(table_of_two(), out);
  const std::string text = out.str();
  CHECK(text.find("# a \"study\" \\| with, marks\n\n6 proofs, 6 verdicts.") == 0);
  CHECK(text.find("| skill in cell | 2 | 1 | 1 | 1 | 1 |") != std::string::npos);
  CHECK(text.find("| 5 ms | 1 | 1 | 1 | 0 | 0 |") != std::string::npos);
  CHECK(text.find("| skill | cell | soon | -3 ms | 5 ms | b |") != std::string::npos);
  CHECK(text.find("| 1 | PAL0708: the period") != std::string::npos);
}

TEST_CASE("of two outcomes the worse counts") {
  CHECK(worse(Outcome::holds, Outcome::never) == Outcome::never);
  CHECK(worse(Outcome::undecided, Outcome::holds) == Outcome::undecided);
  CHECK(worse(Outcome::undecided, Outcome::not_checked) == Outcome::not_checked);
  CHECK(worse(Outcome::fails, Outcome::not_checked) == Outcome::fails);
}

TEST_CASE("slack of a least value is what it lies above its limit") {
  Row row;
  CHECK_FALSE(slack(row));
  row.limit = 5;
  row.bound = 7;
  CHECK(slack(row) == -2);
  row.at_least = true;
  CHECK(slack(row) == 2);
}

TEST_CASE("a map has a field for each pair of values, in the colour of its worst verdict, and a border") {
  const std::string map = draw(table_of_two(), table_of_two().study.plots[1]);
  // Two fields hold; the legend has one more of each kind.
  CHECK(count(map, "class=\"field holds\"") == 2);
  CHECK(count(map, "class=\"field fails\"") == 1);
  CHECK(count(map, "class=\"field undecided\"") == 1);
  CHECK(count(map, "class=\"field never\"") == 1);
  CHECK(count(map, "class=\"field not-checked\"") == 1);
  CHECK(count(map, "class=\"border\"") == 1);
  CHECK(map.find("period = 5 ms, who, first = b: fails") != std::string::npos);

  // With all alike there is no border.
  Table table = table_of_two();
  for (Row& row : table.rows) row.outcome = Outcome::holds;
  CHECK(count(draw(table, table.study.plots[1]), "class=\"border\"") == 0);
  // A field without a row is not green.
  table.rows.pop_back();
  CHECK(count(draw(table, table.study.plots[1]), "class=\"field not-checked\"") == 1);
}

TEST_CASE("a plot of slack shows the least of each value, and marks what has none") {
  const std::string plot = draw(table_of_two(), table_of_two().study.plots[0]);
  // Where something else is not known, the least slack is not drawn, and the axis does not go there.
  CHECK(plot.find("class=\"late\"") == std::string::npos);
  Table known = table_of_two();
  known.rows[2].outcome = Outcome::holds;
  known.rows[2].bound = 8'000'000;
  CHECK(draw(known, known.study.plots[0]).find("class=\"late\"") != std::string::npos);
  CHECK(plot.find("skill in cell, period = 5 ms: -3 ms; something is undecided") != std::string::npos);
  CHECK(plot.find("skill in cell, period = 10 ms: 1.999995 ms; something was not checked") !=
        std::string::npos);
}

TEST_CASE("the names of plots are names of files everywhere") {
  Study study;
  study.figures = {{"extract-z OF LS1", {}, 0}, {"a/b: \"c\"", {}, 0}};
  CHECK(plot_name(study, {{0}}) == "slack-over-extract-z-OF-LS1.svg");
  CHECK(plot_name(study, {{0, 1}}) == "map-of-extract-z-OF-LS1-and-a-b-c.svg");
}
