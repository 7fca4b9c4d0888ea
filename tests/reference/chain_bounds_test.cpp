// Bounds of cause-effect chains, by figures that can be worked out by hand.
#include <catch2/catch.hpp>
#include <string>

#include "tests/reference/bounds_by_hand.hpp"
#include "tests/support/project_file.hpp"

using pal::test::expect_bounds;

namespace {

/// The text of a skill in tests/reference/chains.
std::string chain(const std::string& name) {
  return pal::test::project_file("tests/reference/chains/" + name + ".pal");
}

/// A module works for 2 to 3 ms every 10 and sets a condition, another works for 4 every 20 and reads it.
std::string setter_and_reader(const std::string& kind, const std::string& place) {
  return R"(
MESSAGE tick : SIGNAL
MESSAGE tock : SIGNAL
MESSAGE stop : SIGNAL
DEVICE clock
DEVICE other
CONDITION c
SKILL gives-way
  SENSOR DRIVER      SD1, SD2
  LOGICAL SENSOR     LS1
  MACHINE CONTROLLER NONE
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "done"
  COMPLETION 1 ERROR  "any other error"
  REQUIREMENT value  : AGE OF c AT RPC( c ) IN SD2 AT MOST 1 s
  REQUIREMENT sample : AGE OF tick FROM clock AT RPC( c ) IN SD2 AT MOST 1 s
END SKILL
Sensor Driver: SD1
  ACTIVITY work
BEGIN
  REPEAT
    WTM( tick from clock )
    work
    SPC( c )
  UNTIL( forever )
END
Sensor Driver: SD2
  ACTIVITY work
BEGIN
  REPEAT
    WTM( tock from other )
    work
    RPC( c )
  UNTIL( forever )
END
Logical Sensor: LS1
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  WTM( stop from LS1 )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P1)" +
         kind + R"(
  PROCESSOR idle
  DEVICE clock EVENT tick EVERY 10 ms
  DEVICE other EVENT tock EVERY 20 ms
  DEVICE LS1 EVENT stop SPORADIC 1 ms
  PLACE SD1 ON P1 PRIORITY 2
  PLACE SD2 ON )" +
         place + R"(
  PLACE SM1 ON idle PRIORITY 1
  TIME work OF SD1 : 2 TO 3 ms
  TIME work OF SD2 : 4 ms
END ENVIRONMENT
)";
}

}  // namespace

TEST_CASE("a value goes from a sensor by messages and a condition to a robot") {
  // A sensor sends every 10 ms, its force is there 2 ms later, and a robot asks for a motion every 25 ms.
  // No two threads share a processor. Compositional, exact. The first set comes at 12 ms. Until then the
  // value is as old as the skill. After that sets are 10 apart, and samples are 2 old when they are set. A
  // reaction waits for the next request, 25 later.
  expect_bounds(chain("sensor_and_robot"),
                {{12, 12}, {12, 12}, {37, 37}, {37, 37}, {25, 25}, {25, 25}, {2, 2}});
}

TEST_CASE("blocks in each round of a module") {
  // In each round two blocks: one asks for a force, which takes 4 to 6 ms, the other thinks for 5. The parent
  // goes on when the slower block has ended. The bound does not know that a thinking block ends 5 after the
  // request. It counts 6 at the latest and 4 at the earliest, so the set may be 2 old at the end. Rounds are
  // 25 apart, the thinking ends 5 later in each.
  expect_bounds(chain("blocks_in_a_round"), {{2, 1}, {6, 6}, {6, 6}, {25, 25}, {0, 0}});
}

TEST_CASE("a condition that two blocks set is as old as one of them leaves it") {
  // Rounds are 30 apart. The first set comes 2 after the first round begins, and is read 1 before the act.
  // The bound does not know that a block is over when the next one looks: it counts 2 more for each, and
  // waits for the end of both. A reaction waits for the next act, 20 later.
  expect_bounds(chain("set_in_two_blocks"), {{37, 33}, {57, 53}});
}

TEST_CASE("a response does not include the jitter of its event") {
  // Two clocks with jitter, each for a chain of two modules on two processors, the one always before the
  // other.
  expect_bounds(chain("late_events"), {{3, 3}, {6, 6}, {8, 8}, {15, 15}});
}

TEST_CASE("a reader of lower priority reads no old value while the setter works") {
  // Below the setter the reader does not get between its release and its set: 10 from one release to the
  // next, or to the first. With its priority, or without preemption, it may have been at work before.
  // Elsewhere it reads until the value is set again.
  expect_bounds(setter_and_reader("", "P1 PRIORITY 1"), {{10, 10}, {13, 10}});
  expect_bounds(setter_and_reader("", "P1 PRIORITY 2"), {{17, 14}, {20, 14}});
  expect_bounds(setter_and_reader(" NONPREEMPTIVE", "P1 PRIORITY 1"), {{17, 14}, {20, 14}});
  expect_bounds(setter_and_reader("", "idle PRIORITY 1"), {{13, 13}, {13, 13}});
}
