// Bounds where sends wait for their slots, by numbers that can be reckoned by hand.
#include <catch2/catch.hpp>
#include <string>

#include "tests/figures/bounds_by_hand.hpp"

using pal::test::compare;

namespace {

/// A method asks for a force every 5 ms and sends motions, which a controller obeys at once, but for 20 ms
/// every 100 in which a driver has its processor.
const std::string held_in_its_last_send = R"(
MESSAGE force : REAL N
MESSAGE motion : dz : REAL mm
MESSAGE tick : SIGNAL
DEVICE clock
SKILL held
  SENSOR DRIVER      SD1
  LOGICAL SENSOR     LS1
  MACHINE CONTROLLER MC1
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "done"
  COMPLETION 1 ERROR  "any other error"
  REQUIREMENT taken  : INTERVAL OF WTM( force from LS1 ) IN SM1 AT MOST 1 s
  REQUIREMENT sent   : INTERVAL OF TXM( motion to MC1 ) IN SM1 AT MOST 1 s
  REQUIREMENT obeyed : INTERVAL OF obey IN MC1 AT MOST 1 s
  REQUIREMENT sample : AGE OF force FROM LS1 AT obey IN MC1 AT MOST 1 s
END SKILL
Sensor Driver: SD1
  ACTIVITY work
BEGIN
  REPEAT
    WTM( tick from clock )
    work
  UNTIL( forever )
END
Logical Sensor: LS1
Machine Controller: MC1
  ACTIVITY obey
BEGIN
  REPEAT
    WTM( motion from SM1 )
    obey
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  TXM( request force from LS1 )
  REPEAT
    WTM( force from LS1 )
    TXM( request force from LS1 )
    TXM( motion to MC1 )
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P1
  PROCESSOR P2
  DEVICE LS1 ON REQUEST 5 ms
  DEVICE clock EVENT tick EVERY 100 ms
  PLACE SM1 ON P1 PRIORITY 1
  PLACE MC1 ON P2 PRIORITY 1
  PLACE SD1 ON P2 PRIORITY 2
  TIME obey : 1 ms
  TIME work : 20 ms
END ENVIRONMENT
)";

/// A clock of 10 ms with jitter, a courier without work, and a module that is kept from its processor for 14
/// ms every 50: the courier's next send finds the slot full.
const std::string full_slot = R"(
MESSAGE tick : SIGNAL
MESSAGE tock : SIGNAL
MESSAGE first : SIGNAL
MESSAGE stop : SIGNAL
DEVICE clock
DEVICE other
SKILL full
  SENSOR DRIVER      SD1, SD2
  LOGICAL SENSOR     LS1, LS3
  MACHINE CONTROLLER NONE
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "done"
  COMPLETION 1 ERROR  "any other error"
  REQUIREMENT sent : RESPONSE FROM tick OF clock TO TXM( first to LS1 ) IN SD1 AT MOST 1 s
  REQUIREMENT done : RESPONSE FROM tick OF clock TO work IN LS1 AT MOST 1 s
END SKILL
Sensor Driver: SD1
BEGIN
  REPEAT
    WTM( tick from clock )
    TXM( first to LS1 )
  UNTIL( forever )
END
Logical Sensor: LS1
  ACTIVITY work
BEGIN
  REPEAT
    WTM( first from SD1 )
    work
  UNTIL( forever )
END
Sensor Driver: SD2
  ACTIVITY work
BEGIN
  REPEAT
    WTM( tock from other )
    work
  UNTIL( forever )
END
Logical Sensor: LS3
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  WTM( stop from LS3 )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P1
  PROCESSOR P2
  PROCESSOR idle
  DEVICE clock EVENT tick EVERY 10 ms JITTER 2 ms
  DEVICE other EVENT tock EVERY 50 ms
  DEVICE LS3 EVENT stop SPORADIC 1 ms
  PLACE SD1 ON P1 PRIORITY 2
  PLACE SD2 ON P2 PRIORITY 2
  PLACE LS1 ON P2 PRIORITY 1
  PLACE SM1 ON idle PRIORITY 1
  TIME work OF SD2 : 14 ms
  TIME work OF LS1 : 1 ms
END ENVIRONMENT
)";

}  // namespace

TEST_CASE("a wait for a slot holds up the round that follows") {
  // The controller begins to obey 20 late and takes the motion then. The method is held with the next one, 5
  // later, and is home 15 after that round began.
  compare(held_in_its_last_send, {{15, 15}, {30, 20}, {35, 25}, {36, 26}});
}

TEST_CASE("who waits for a slot does not keep its taker waiting") {
  // An event comes 2 late and its message is taken 14 later. The next event is punctual, and its message held
  // for 6. No message is done later than 14 and 1 after its event.
  compare(full_slot, {{6, 6}, {15, 15}});
}
