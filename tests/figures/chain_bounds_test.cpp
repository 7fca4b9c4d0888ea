// Bounds of cause-effect chains, by numbers that can be reckoned by hand.
#include <catch2/catch.hpp>

#include "analyzer/compositional/compositional.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

constexpr const char* declarations = R"(
MESSAGE force : REAL N
MESSAGE raw : REAL N
MESSAGE motion : dz : REAL mm
CONDITION pc-force FROM force "touching"
DEVICE sensor "raw forces"
SKILL chain
  SENSOR DRIVER      SD1
  LOGICAL SENSOR     LS1
  MACHINE CONTROLLER MC1
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "done"
  COMPLETION 1 ERROR  "any other error"
)";

/// A sensor sends every 10 ms, its force is there 2 ms later, and a robot asks for a motion every 25 ms. Nobody
/// shares a processor.
const std::string sensor_and_robot = std::string(declarations) + R"(
  REQUIREMENT value  : AGE OF pc-force AT TXM( motion to MC1 ) IN SM1 AT MOST 1 s
  REQUIREMENT sample : AGE OF raw FROM sensor AT TXM( motion to MC1 ) IN SM1 AT MOST 1 s
  REQUIREMENT set    : REACTION OF pc-force AT TXM( motion to MC1 ) IN SM1 AT MOST 1 s
  REQUIREMENT world  : REACTION OF raw FROM sensor AT TXM( motion to MC1 ) IN SM1 AT MOST 1 s
  REQUIREMENT most   : INTERVAL OF TXM( motion to MC1 ) IN SM1 AT MOST 1 s
  REQUIREMENT least  : INTERVAL OF TXM( motion to MC1 ) IN SM1 AT LEAST 1 ms
  REQUIREMENT known  : AGE OF raw FROM sensor AT SPC( pc-force ) IN SM1 AT MOST 1 s
END SKILL
Sensor Driver: SD1
BEGIN
  REPEAT
    WTM( raw from sensor )
    TXM( raw to LS1 )
  UNTIL( forever )
END
Logical Sensor: LS1
  ACTIVITY extract READS raw WRITES force
BEGIN
  REPEAT
    WTM( raw from SD1 )
    extract
    TXM( force to SM1 )
  UNTIL( forever )
END
Machine Controller: MC1
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  CONCURRENT
  BEGIN
    REPEAT
      WTM( force from LS1 )
      SPC( pc-force )
    UNTIL( forever )
  END
  BEGIN
    REPEAT
      WTM( motion request from MC1 )
      RPC( pc-force )
      TXM( motion to MC1 )
    UNTIL( forever )
  END
  END CONCURRENT
END
ENVIRONMENT cell
  PROCESSOR P1
  PROCESSOR P2
  PROCESSOR P3
  DEVICE sensor EVENT raw EVERY 10 ms
  DEVICE MC1 EVENT motion request EVERY 25 ms
  PLACE SD1 ON P1 PRIORITY 1
  PLACE LS1 ON P2 PRIORITY 1
  PLACE SM1 ON P3 PRIORITY 1
  TIME extract : 2 ms
END ENVIRONMENT
)";

/// In each round two blocks: one asks for a force, which takes 4 to 6 ms, the other thinks for 5.
const std::string blocks_in_a_round = std::string(declarations) + R"(
  REQUIREMENT value  : AGE OF pc-force AT TXM( motion to MC1 ) IN SM1 AT MOST 1 s
  REQUIREMENT sample : AGE OF force FROM LS1 AT SPC( pc-force ) IN SM1 AT MOST 1 s
  REQUIREMENT answer : RESPONSE FROM motion request OF MC1 TO TXM( motion to MC1 ) AT MOST 1 s
  REQUIREMENT most   : INTERVAL OF think IN SM1 AT MOST 1 s
  REQUIREMENT lost   : LOSS OF LS1 NONE
END SKILL
Sensor Driver: SD1
Logical Sensor: LS1
Machine Controller: MC1
Skill Module: SM1
  ACTIVITY think
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( motion request from MC1 )
    CONCURRENT
    BEGIN
      TXM( request force from LS1 )
      WTM( force from LS1 )
      SPC( pc-force )
    END
    BEGIN
      think
    END
    END CONCURRENT
    RPC( pc-force )
    TXM( motion to MC1 )
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P1
  PROCESSOR P2
  DEVICE LS1 ON REQUEST 4 TO 6 ms
  DEVICE MC1 EVENT motion request EVERY 25 ms
  PLACE SM1 ON P1 PRIORITY 1
  PLACE SM1.2 ON P2 PRIORITY 1
  TIME think : 5 ms
END ENVIRONMENT
)";

double milliseconds(const Verdict& verdict) {
  return verdict.bound ? static_cast<double>(verdict.bound->count()) / 1e6 : -1;
}

void compare(const std::string& text, const std::vector<std::pair<double, double>>& expected) {
  const auto skill = test::sound_skill(text);
  const Analysis compositional = analyze_compositionally(*skill->problem);
  const Analysis exact = analyze(*skill->problem);
  REQUIRE(compositional.verdicts.size() == expected.size());
  for (std::size_t r = 0; r < expected.size(); ++r) {
    INFO(compositional.verdicts[r].requirement << ": " << compositional.verdicts[r].explanation);
    CHECK(milliseconds(compositional.verdicts[r]) == expected[r].first);
    CHECK(milliseconds(exact.verdicts[r]) == expected[r].second);
  }
}

/// SM1 talks to MC1, whose work takes 4 ms, once; how long until it completes is asked.
std::string once(const std::string& server, const std::string& client) {
  return R"(
MESSAGE early  : SIGNAL
MESSAGE late   : SIGNAL
MESSAGE taken  : SIGNAL
MESSAGE done   : SIGNAL
MESSAGE motion : SIGNAL
SKILL once
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT span : DURATION TO COMPLETION 0 AT MOST 1 s
END SKILL
Machine Controller: MC1
  ACTIVITY work
BEGIN
  REPEAT
)" + server +
         R"(
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY pause
BEGIN
  WTM( Coordinator )
)" + client +
         R"(
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR P1
  PLACE SM1 ON P0 PRIORITY 1
  PLACE MC1 ON P1 PRIORITY 1
  TIME work  : 4 ms
  TIME pause : 1 ms
  COST TEST 1 ms
END ENVIRONMENT
)";
}

}  // namespace

TEST_CASE("a value goes from a sensor by messages and a condition to a robot") {
  // Compositional, exact. The first set comes at 12 ms, until when the value is as old as the skill; after that
  // sets are 10 apart, and samples 2 old when they are set. A reaction waits for the next request, 25 later.
  compare(sensor_and_robot, {{12, 12}, {12, 12}, {37, 37}, {37, 37}, {25, 25}, {25, 25}, {2, 2}});
}

TEST_CASE("blocks in each round of a module") {
  // The parent goes on when the slower block has ended. What the bound does not know is that a thinking block
  // ends 5 after the request, so that the set may be 2 old at the end at most: 6 at the latest, 4 at the
  // earliest. Rounds are 25 apart, the thinking ends 5 later in each.
  compare(blocks_in_a_round, {{2, 1}, {6, 6}, {6, 6}, {25, 25}, {0, 0}});
}

TEST_CASE("what a thread is sent next may come while it is still at work") {
  // 4 ms for the first, then 4 for the second, which came at 1. The bound does not know that the first was
  // begun before.
  compare(once(R"(
    WTM FIRST
      ( early from SM1 ):
        work
      ( late from SM1 ):
        work
        TXM( done to SM1 )
    END WTM
)",
               "TXM( early to MC1 )\npause\nTXM( late to MC1 )\nWTM( done from MC1 )\n"),
          {{9, 8}});
}

TEST_CASE("a thread that answers first and works then is at work when it is sent more") {
  compare(once(R"(
    WTM FIRST
      ( early from SM1 ):
        TXM( taken to SM1 )
        work
      ( late from SM1 ):
        work
        TXM( done to SM1 )
    END WTM
)",
               "TXM( early to MC1 )\nWTM( taken from MC1 )\npause\nTXM( late to MC1 )\n"
               "WTM( done from MC1 )\n"),
          {{9, 8}});
}

TEST_CASE("a server goes on with a request that was withdrawn") {
  // The client gives up at 2, asks again at 3 after its test, and is served from 4 to 8. The bound counts both
  // ways on which it may ask for the second time.
  compare(once(R"(
    WTM( request motion from SM1 )
    work
    TXM( motion to SM1 )
)",
               R"(
  TXM( request motion from MC1 )
  WTM( motion from MC1 ) WITHIN 2 ms
    pause
  ELSE
    Do Nothing
  END WTM
  TXM( request motion from MC1 )
  WTM( motion from MC1 )
)"),
          {{15, 8}});
}
