// Bounds of the age of samples, by figures that can be worked out by hand.
#include <catch2/catch.hpp>

#include "tests/reference/bounds_by_hand.hpp"

using pal::test::expect_bounds;

TEST_CASE("a sample of the previous job is a period older than one of this job") {
  // The image is asked for after hold, at 1 ms at the earliest, and used in the next job. There hold ends at
  // 28 + 3 ms at the latest. The bound does not count the 1 ms.
  expect_bounds(R"(
DEVICE camera
DEVICE clock
MESSAGE image  : n : INTEGER
MESSAGE tick   : SIGNAL
MESSAGE motion : n : INTEGER
Machine Controller: MC1
  ACTIVITY hold READS image WRITES motion
BEGIN
  REPEAT
    WTM( tick from clock )
    hold
    TXM( motion to clock )
    TXM( request image from camera )
    WTM( image from camera )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY pause
BEGIN
  WTM( Coordinator )
  pause
  TXM( Completion Protocol 0 )
END
SKILL pipelined
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT fresh : AGE OF image FROM camera AT hold AT MOST 1 s
END SKILL
ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR P1
  DEVICE camera ON REQUEST 2 TO 5 ms
  DEVICE clock EVENT tick EVERY 28 ms ANSWER motion WITHIN 20 ms
  PLACE MC1 ON P0 PRIORITY 1
  PLACE SM1 ON P1 PRIORITY 1
  TIME hold  : 1 TO 3 ms
  TIME pause : 1 s
END ENVIRONMENT
)",
                {{31, 30}, {3, 3}});
}
