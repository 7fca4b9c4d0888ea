// Responses to messages of modules and of devices that are asked, added up by hand.
#include <catch2/catch.hpp>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/exact/exact.hpp"
#include "tests/support/confirm.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::sound_skill;
using namespace std::chrono_literals;

namespace {

std::string answers(const std::string& requirements, const std::string& controller, const std::string& method,
                    const std::string& decide) {
  return R"(MESSAGE tick       : SIGNAL
MESSAGE force      : REAL N
MESSAGE motion     : dz : REAL mm
MESSAGE correction : dz : REAL mm
DEVICE alter
SKILL answers
  LOGICAL SENSOR     LS1
  MACHINE CONTROLLER MC1
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
)" + requirements +
         R"(END SKILL
Logical Sensor: LS1
Machine Controller: MC1
  ACTIVITY obey READS motion WRITES correction
BEGIN
  REPEAT
    WTM( tick from alter )
    TXM( request motion from SM1 )
)" + controller +
         R"(  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY decide WRITES motion
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( request motion from MC1 )
)" + method +
         R"(  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR P1
  DEVICE alter EVENT tick EVERY 28 ms
  DEVICE LS1   ON REQUEST 5 TO 6 ms
  PLACE SM1 ON P0 PRIORITY 1
  PLACE MC1 ON P1 PRIORITY 1
  TIME decide OF SM1 : )" +
         decide + R"(
  TIME obey OF MC1 : 0.25 ms
  COST SEND 0.5 ms
  COST RECEIVE 0.25 ms
  LATENCY BETWEEN PROCESSORS 0 TO 1 ms
END ENVIRONMENT
)";
}

/// Of the requirement `index`: the bound is so much, and some run attains it; the referee agrees.
void expect_exact(const Problem& problem, const Analysis& analysis, std::size_t index, Duration bound) {
  const Verdict& found = analysis.verdicts[index];
  INFO(found.requirement << ": " << name(found.state) << ", " << found.explanation.text());
  CHECK(found.state == VerdictState::holds);
  REQUIRE(found.bound);
  CHECK(*found.bound == bound);
  CHECK(found.exact);
  CHECK(test::unexplained(found) == "");
  CHECK(test::unconfirmed(problem, analysis) == "");
}

}  // namespace

TEST_CASE("a response to a message counts from its sending, by any module") {
  const auto skill = sound_skill(answers(R"(
  REQUIREMENT motion : RESPONSE FROM request motion OF MC1 TO TXM( motion to MC1 ) AT MOST 20 ms
  REQUIREMENT obeyed : RESPONSE FROM motion OF SM1 TO TXM( correction to alter ) AT MOST 20 ms
  REQUIREMENT used   : RESPONSE FROM force OF LS1 TO decide IN SM1 AT MOST 20 ms
  REQUIREMENT served : RESPONSE FROM request force OF SM1 TO decide IN SM1 AT MOST 20 ms
)",
                                         R"(
    WTM( motion from SM1 )
    obey
    TXM( correction to alter )
)",
                                         R"(
    TXM( request force from LS1 )
    WTM( force from LS1 )
    decide
    TXM( motion to MC1 )
)",
                                         "1 TO 2 ms"));
  const Analysis analysis = analyze_exactly(*skill->problem);
  expect_exact(*skill->problem, analysis, 0, 10500us);  // 1 + 0.25 + 0.5 + 6 + 0.25 + 2 + 0.5
  expect_exact(*skill->problem, analysis, 1, 2000us);   // 1 + 0.25 + 0.25 + 0.5
  expect_exact(*skill->problem, analysis, 2, 2250us);   // 0.25 + 2
  expect_exact(*skill->problem, analysis, 3, 8250us);   // 6 + 0.25 + 2
  // MC1 asks 0.75 ms after the tick, the only one that can be late; it asks again when it has its answer.
  const Analysis bounds = compositional::analyze(*skill->problem, {});
  REQUIRE(bounds.verdicts[0].bound);
  CHECK(*bounds.verdicts[0].bound == 10500us);
}

// SM1 decides for 40 ms, so every second request finds it at work; 3 ms later it is withdrawn.
TEST_CASE("a request that is withdrawn before it is taken awaits no response") {
  const auto skill = sound_skill(answers(R"(
  REQUIREMENT motion : RESPONSE FROM request motion OF MC1 TO TXM( motion to MC1 ) AT MOST 20 ms
)",
                                         R"(
    WTM( motion from SM1 ) WITHIN 3 ms
      obey
      TXM( correction to alter )
    ELSE
      Do Nothing
    END WTM
)",
                                         R"(
    TXM( motion to MC1 )
    decide
)",
                                         "40 ms"));
  expect_exact(*skill->problem, analyze_exactly(*skill->problem), 0, 1750us);  // 1 + 0.25 + 0.5
}

TEST_CASE("a request to two parties: the second is answered, the first is not") {
  // LS1 thinks for 10 ms, LS2 answers at once: the next thread asks when it has both answers.
  const auto skill = sound_skill(R"(MESSAGE tick : SIGNAL
MESSAGE force : SIGNAL
DEVICE robot
SKILL asked
  LOGICAL SENSOR LS1, LS2
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r : RESPONSE FROM request force OF SM1 TO TXM( force to SM1 ) AT MOST 1 s
END SKILL
Logical Sensor: LS1
  ACTIVITY slow
BEGIN
  REPEAT
    WTM( request force from SM1 )
    slow
    TXM( force to SM1 )
  UNTIL( forever )
END
Logical Sensor: LS2
BEGIN
  REPEAT
    WTM( request force from SM1 )
    TXM( force to SM1 )
  UNTIL( forever )
END
Machine Controller: MC1
BEGIN
  REPEAT
    WTM( tick from robot )
    TXM( tick to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( tick from MC1 )
    TXM( request force from LS1 )
    TXM( request force from LS2 )
    WTM( force from LS1 )
    WTM( force from LS2 )
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P
  PROCESSOR Q
  PROCESSOR R
  PROCESSOR S
  DEVICE robot EVENT tick EVERY 100 ms
  PLACE LS1 ON P PRIORITY 1
  PLACE LS2 ON Q PRIORITY 1
  PLACE SM1 ON R PRIORITY 1
  PLACE MC1 ON S PRIORITY 1
  TIME slow : 10 ms
  COST SEND 1 ms
END ENVIRONMENT
)");
  CHECK_FALSE(compositional::analyze(*skill->problem, {}).verdicts.front().bound);
  const Verdict found = analyze_exactly(*skill->problem).verdicts.front();
  CHECK(found.state == VerdictState::fails);
  REQUIRE(found.witness);
  CHECK(found.witness->failed);
}
