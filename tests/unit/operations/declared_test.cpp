// What skills declare beside their PAL: the form of the text, and whether it fits the skill.
#include "operations/declared.hpp"

#include "tests/unit/operations/support.hpp"

using namespace pal;
using namespace pal::operations;

namespace {

Declared right(const std::string& text) {
  const auto read = read_declared(text);
  if (const auto* wrong = std::get_if<DeclaredError>(&read)) FAIL(wrong->line << ": " << wrong->cause);
  return std::get<Declared>(read);
}

void expect_wrong(const std::string& text, int line, const std::string& cause) {
  INFO(text);
  const auto read = read_declared(text);
  const auto* wrong = std::get_if<DeclaredError>(&read);
  REQUIRE(wrong != nullptr);
  CHECK(wrong->line == line);
  INFO(wrong->cause);
  CHECK(wrong->cause.find(cause) != std::string::npos);
}

pan::Template press() {
  pan::Template skill;
  skill.name = "press";
  for (const char* name : {"reach", "speed", "band"}) {
    pan::Parameter parameter;
    parameter.name = name;
    parameter.low = 0;
    parameter.high = 100;
    parameter.default_value = 10;
    skill.parameters.push_back(parameter);
  }
  pan::Parameter place;
  place.name = "place";
  place.type = pan::ScalarType::text;
  skill.parameters.push_back(place);
  pan::Completion done, error;
  error.code = 2;
  error.kind = pan::Completion::Kind::error;
  skill.completions = {done, error};
  return skill;
}

void expect_misfit(const std::string& text, int line, const std::string& cause) {
  INFO(text);
  const auto wrong = misfit(right(text), press());
  REQUIRE(wrong);
  CHECK(wrong->line == line);
  INFO(wrong->cause);
  CHECK(wrong->cause.find(cause) != std::string::npos);
}

}  // namespace

TEST_CASE("a skill declares longest times and limits, a line each") {
  const Declared declared = right(
      "# why\n"
      "longest 0: reach / speed + 2   # a comment\r\n"
      "\n"
      "\tlongest 2 : 120\n"
      "limit fz of force: target -threshold\n"
      "limit fx, fy ,fz of force: stop +- 0.05 * stop-force\n"
      "limit z of profile: band -2*distance +- - 3 * tolerance");
  REQUIRE(declared.longest.size() == 2);
  CHECK(declared.longest.at(0).line == 2);
  CHECK(declared.longest.at(0).seconds.text() == "reach / speed + 2");
  CHECK(declared.longest.at(2).seconds.text() == "120");
  REQUIRE(declared.limits.size() == 3);

  const DeclaredLimit& target = declared.limits[0];
  CHECK(target.line == 5);
  CHECK(target.channel == "force");
  CHECK(target.fields == std::vector<std::string>{"fz"});
  CHECK(target.kind == DeclaredLimit::Kind::target);
  CHECK_FALSE(target.both);
  CHECK(target.at.parameter == "threshold");
  CHECK(target.at.factor == -1);
  CHECK_FALSE(target.around);

  const DeclaredLimit& stop = declared.limits[1];
  CHECK(stop.fields == std::vector<std::string>{"fx", "fy", "fz"});
  CHECK(stop.kind == DeclaredLimit::Kind::stop);
  CHECK(stop.both);
  CHECK(stop.at.parameter == "stop-force");
  CHECK(stop.at.factor == 0.05);
  CHECK_FALSE(stop.around);

  const DeclaredLimit& band = declared.limits[2];
  CHECK(band.kind == DeclaredLimit::Kind::band);
  CHECK(band.both);
  CHECK(band.at.parameter == "tolerance");
  CHECK(band.at.factor == -3);
  REQUIRE(band.around);
  CHECK(band.around->parameter == "distance");
  CHECK(band.around->factor == -2);

  CHECK(right("").longest.empty());
  CHECK(right("limit fz of force: error x").limits[0].kind == DeclaredLimit::Kind::error);
}

TEST_CASE("a line that declares nothing is told with its number") {
  expect_wrong("longest 0: 1\nlogest 1: 2\n", 2, "a line is written as");
  expect_wrong("longest: 2", 1, "a line is written as");
  expect_wrong("longest 0 2", 1, "a line is written as");
  expect_wrong("longest 99999999999: 2", 1, "a line is written as");
  expect_wrong("longest 0:", 1, "'' is no formula");
  expect_wrong("longest 0: reach over speed", 1, "'reach over speed' is no formula");
  expect_wrong("longest 0: 1\n\nlongest 0: 2", 3, "declared twice");
  expect_wrong("limit fz: target x", 1, "a line is written as");
  expect_wrong("limit fx, of force: target x", 1, "a line is written as");
  expect_wrong("limit fz of : target x", 1, "a line is written as");
  expect_wrong("limit fz of force:", 1, "a line is written as");
  expect_wrong("limit fz of force: bound x", 1,
               "there is no limit 'bound'; there are band, target, stop, error");
  expect_wrong("limit fz of force: target", 1, "a limit is PARAMETER");
  expect_wrong("limit fz of force: target 5", 1, "a limit is PARAMETER");
  expect_wrong("limit fz of force: target x +- ", 1, "a limit is PARAMETER");
  expect_wrong("limit fz of force: target x + y", 1, "'+ y' is more than a limit has");
  expect_wrong("limit fz of force: target +- x +- y", 1, "'+- y' is more than a limit has");
}

TEST_CASE("what is declared has to fit the skill") {
  CHECK_FALSE(
      misfit(right("longest 0: reach / speed\nlongest 2: max(band, 3)\nlimit z of force: band reach +- band"),
             press()));
  expect_misfit("longest 0: 1\nlongest 1: 1", 2, "press has no completion 1");
  expect_misfit("longest 0: reach / sped", 1, "press has no parameter 'sped'");
  expect_misfit("longest 0: place", 1, "the parameter 'place' is no number");
  expect_misfit("longest 0: 1 / (reach - speed)", 1, "no time when all parameters have their defaults");
  expect_misfit("longest 0: 1 - reach", 1, "no time when all parameters have their defaults");
  expect_misfit("\nlimit fz of force: target force", 2, "press has no parameter 'force'");
  expect_misfit("limit fz of force: target place", 1, "the parameter 'place' is no number");
  expect_misfit("limit fz of force: target middle +- band", 1, "press has no parameter 'middle'");
}
