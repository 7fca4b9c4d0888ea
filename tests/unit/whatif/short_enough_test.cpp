#include "analyzer/whatif/short_enough.hpp"

#include <catch2/catch.hpp>

#include "analyzer/analysis.hpp"
#include "tests/support/skill.hpp"
#include "tests/unit/whatif/two_chains.hpp"

using namespace pal;
using namespace pal::analyzer;
using namespace pal::analyzer::whatif;

namespace {

std::vector<ShortEnough> found_of(const std::string& text) {
  const auto skill = test::sound_skill(text);
  const Analysis analysis = analyze(*skill->problem, AnalysisChoice::automatic);
  return short_enough_times(skill->specification.skills.front(), skill->specification.environments.front(),
                            analysis.verdicts, Options());
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

constexpr Duration ms(std::int64_t n) {
  return Duration(n * 1'000'000);
}

}  // namespace

TEST_CASE("each time by itself becomes as short as it must") {
  // 5 ms of heavy and 2 ms of answer are 7 ms.
  const auto found = found_of(test::two_chains("6 ms"));
  REQUIRE(found.size() == 2);
  CHECK(found[0].figure == "answer OF SM1");
  CHECK(found[0].time.worst == ms(2));
  CHECK(found[0].enough.best == ms(0));
  CHECK(found[0].enough.worst == ms(1));
  CHECK(found[1].figure == "heavy OF LS1");
  CHECK(found[1].enough.worst == ms(4));
}

TEST_CASE("a time that does not suffice by itself is left out") {
  const auto found = found_of(test::two_chains("4 ms"));
  REQUIRE(found.size() == 1);
  CHECK(found[0].figure == "heavy OF LS1");
  CHECK(found[0].enough.worst == ms(2));
}

TEST_CASE("each requirement that fails is mended by itself, and nothing that holds is broken") {
  // Heavy is there after 5 ms, and the answer after 7 ms.
  std::string text = test::two_chains("6 ms");
  text.insert(text.find("END SKILL"),
              "  REQUIREMENT steady : RESPONSE FROM tock OF SD1 TO heavy AT MOST 3 ms\n");
  const auto found = found_of(text);
  REQUIRE(found.size() == 3);
  CHECK(found[0].requirement == RequirementId(0));
  CHECK(found[0].figure == "answer OF SM1");
  CHECK(found[1].requirement == RequirementId(0));
  CHECK(found[1].figure == "heavy OF LS1");
  CHECK(found[1].enough.worst == ms(4));
  CHECK(found[2].requirement == RequirementId(1));
  CHECK(found[2].figure == "heavy OF LS1");
  CHECK(found[2].enough.worst == ms(3));
}

TEST_CASE("the best time stays if that suffices") {
  const auto found =
      found_of(replaced(test::two_chains("6 ms"), "heavy OF LS1 : 5", "heavy OF LS1 : 3 TO 5"));
  REQUIRE(found.size() == 2);
  CHECK(found[1].enough.best == ms(3));
  CHECK(found[1].enough.worst == ms(4));
}

TEST_CASE("a shorter time with which a requirement says nothing any more does not count") {
  // With a shorter answer the wait never comes to its ELSE, so nothing is late, and nothing is measured.
  CHECK(found_of(R"(MESSAGE tick  : SIGNAL
MESSAGE force : REAL N
SKILL s
  LOGICAL SENSOR LS1
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT soon : RESPONSE FROM tick OF MC1 TO late IN SM1 AT MOST 1 ms
END SKILL
Machine Controller: MC1
Logical Sensor: LS1
  ACTIVITY look WRITES force
BEGIN
  REPEAT
    WTM( request force from SM1 )
    look
    TXM( force to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY late
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( tick from MC1 )
    TXM( request force from LS1 )
    WTM( force from LS1 ) WITHIN 3 ms
      Do Nothing
    ELSE
      late
    END WTM
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR P1
  DEVICE MC1 EVENT tick EVERY 10 ms
  PLACE SM1 ON P0 PRIORITY 1
  PLACE LS1 ON P1 PRIORITY 1
  TIME look OF LS1 : 2 TO 4 ms
  TIME late OF SM1 : 0.1 ms
END ENVIRONMENT
)")
            .empty());
}
