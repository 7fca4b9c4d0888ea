// Bounds of what a thread is sent once while it is at work, by figures that can be worked out by hand.
#include <catch2/catch.hpp>
#include <string>

#include "tests/reference/bounds_by_hand.hpp"

using pal::test::expect_bounds;

namespace {

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

TEST_CASE("what a thread is sent next may come while it is still at work") {
  // 4 ms for the first, then 4 for the second, which came at 1. The bound does not know that the first was
  // begun before.
  expect_bounds(once(R"(
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

TEST_CASE("a thread that answers before it works is busy when more comes") {
  expect_bounds(once(R"(
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
  // The client gives up at 2, asks again at 3 after its test, and is served from 4 to 8. The bound counts
  // The client gives up at 2, asks again at 3 after its test, and is served from 4 to 8. The bound counts the
  // first work in full, as if it began at 3.
  expect_bounds(once(R"(
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
                {{11, 8}});
}

namespace {

/// SM1 asks two servers that share a processor. The work of each takes 4 ms. On the same processor, between
/// them, `tick` takes 3 ms of every 6 ms if `ticking`.
std::string two_servers(const std::string& client, bool ticking = false) {
  const std::string tick = R"(
DEVICE clock
MESSAGE time : SIGNAL
Sensor Driver: SD1
  ACTIVITY tick
BEGIN
  REPEAT
    WTM( time from clock )
    tick
  UNTIL( forever )
END
)";
  const std::string ticks = R"(
  DEVICE clock EVENT time EVERY 6 ms
  PLACE SD1 ON P1 PRIORITY 2
  TIME tick : 3 ms
)";
  return R"(
MESSAGE low  : SIGNAL
MESSAGE high : SIGNAL
)" + (ticking ? tick : "") +
         R"(
Machine Controller: MC1
  ACTIVITY work
BEGIN
  REPEAT
    WTM( request low from SM1 )
    work
    TXM( low to SM1 )
  UNTIL( forever )
END
Machine Controller: MC2
  ACTIVITY work
BEGIN
  REPEAT
    WTM( request high from SM1 )
    work
    TXM( high to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
)" + client +
         R"(
  TXM( Completion Protocol 0 )
END
SKILL twice
)" + (ticking ? "  SENSOR DRIVER SD1\n" : "") +
         R"(
  MACHINE CONTROLLER MC1, MC2
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT span : DURATION TO COMPLETION 0 AT MOST 1 s
END SKILL
ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR P1
  PLACE SM1 ON P0 PRIORITY 1
  PLACE MC1 ON P1 PRIORITY 1
  PLACE MC2 ON P1 PRIORITY 3
  TIME work : 4 ms
)" + (ticking ? ticks : "") +
         "END ENVIRONMENT\n";
}

}  // namespace

TEST_CASE("what is over does not delay work that comes once") {
  // 8 ms a round: MC2 works from 0 to 4, MC1 from 4 to 8.
  const std::string round = R"(
  TXM( request low from MC1 )
  TXM( request high from MC2 )
  WTM( high from MC2 )
  WTM( low from MC1 )
)";
  expect_bounds(two_servers(round + round), {{16, 16}});
}

TEST_CASE("what is over may have held up work that recurs") {
  // MC2 works from 0 to 4. The ticks of 0 and 6 then run from 4 to 10, and MC1 until 17, with that of 12 in
  // between. Without MC2's work the bound would be 14.
  expect_bounds(two_servers(R"(
  TXM( request high from MC2 )
  WTM( high from MC2 )
  TXM( request low from MC1 )
  WTM( low from MC1 )
)",
                            true),
                {{21, 17}});
}

TEST_CASE("what is asked once counts from the request, not from the start of the skill") {
  // 9 ms for the image and 4 ms for the work. The second request comes at 5 at the earliest, and the second
  // answer at 26 at the latest; but no run has both. A response is bounded by both all the same. It has a
  // bound because each request follows the answer before, although answers may be 5 ms apart.
  expect_bounds(R"(
DEVICE camera
MESSAGE image : n : INTEGER
MESSAGE pose  : n : INTEGER
Sensor Driver: SD1
BEGIN
  REPEAT
    WTM( request image from LS1 )
    TXM( request image from camera )
    WTM( image from camera )
    TXM( image to LS1 )
  UNTIL( forever )
END
Logical Sensor: LS1
  ACTIVITY locate READS image WRITES pose
BEGIN
  REPEAT
    WTM( request pose from SM1 )
    TXM( request image from SD1 )
    WTM( image from SD1 )
    locate
    TXM( pose to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY evaluate
BEGIN
  WTM( Coordinator )
  TXM( request pose from LS1 )
  WTM( pose from LS1 )
  TXM( request pose from LS1 )
  WTM( pose from LS1 )
  evaluate
  TXM( Completion Protocol 0 )
END
SKILL twice
  SENSOR DRIVER SD1
  LOGICAL SENSOR LS1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT fresh  : AGE OF image FROM camera AT evaluate AT MOST 1 s
  REQUIREMENT served : RESPONSE FROM request pose OF SM1 TO TXM( pose to SM1 ) AT MOST 1 s
END SKILL
ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR P1
  DEVICE camera ON REQUEST 1 TO 9 ms
  PLACE SM1 ON P0 PRIORITY 1
  PLACE SD1 ON P1 PRIORITY 2
  PLACE LS1 ON P1 PRIORITY 1
  TIME locate   : 4 ms
  TIME evaluate : 0 ms
END ENVIRONMENT
)",
                {{13, 13}, {21, 13}});
}
