// What the compositional analysis once took for granted, each with a skill of which it is not so.
#include <catch2/catch.hpp>
#include <string>

#include "tests/figures/bounds_by_hand.hpp"
#include "tests/support/any_skill.hpp"

using pal::test::compare;

namespace {

const std::string preempted = R"(
MESSAGE correction : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE tick : SIGNAL
CONDITION c
DEVICE robot
SKILL odd
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r0 : DURATION TO COMPLETION 0 AT MOST 1 s
END SKILL
Machine Controller: MC1
  ACTIVITY obey
BEGIN
  REPEAT
    WTM( tick from robot )
    obey
    TXM( correction to robot )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY first
  ACTIVITY long
  ACTIVITY last
BEGIN
  WTM( Coordinator )
  first
  CONCURRENT
  BEGIN
    long
  END
  END CONCURRENT
  last
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P
  PROCESSOR Q
  PLACE MC1 ON P PRIORITY 4
  PLACE SM1 ON P PRIORITY 3
  PLACE SM1.1 ON P PRIORITY 5
  TIME obey : 9 ms
  TIME first : 0.5 ms
  TIME long : 25 ms
  TIME last : 1 ms
  DEVICE robot EVENT tick EVERY 20 ms
END ENVIRONMENT
)";

const std::string held = R"(
MESSAGE correction : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE step : SIGNAL
MESSAGE touch : SIGNAL
MESSAGE tick : SIGNAL
CONDITION c
DEVICE robot
DEVICE hand
SKILL odd
  MACHINE CONTROLLER MC1, MC2, MC3
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r0 : AGE OF c AT TXM( motion to MC1 ) AT MOST 1 s
END SKILL
Machine Controller: MC1
  ACTIVITY obey
BEGIN
  REPEAT
    WTM( motion from SM1 )
    obey
  UNTIL( forever )
END
Machine Controller: MC2
BEGIN
  REPEAT
    WTM( tick from robot )
    TXM( step to SM1 )
  UNTIL( forever )
END
Machine Controller: MC3
  ACTIVITY block
BEGIN
  REPEAT
    WTM( touch from hand )
    block
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( step from MC2 )
    SPC( c )
    RPC( c )
    TXM( motion to MC1 )
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P
  PROCESSOR Q
  PROCESSOR R
  PLACE MC1 ON Q PRIORITY 4
  PLACE MC2 ON R PRIORITY 2
  PLACE SM1 ON P PRIORITY 3
  TIME obey : 5 ms
  TIME block : 45 ms
  PLACE MC3 ON Q PRIORITY 9
  DEVICE robot EVENT tick EVERY 30 ms 
  DEVICE hand EVENT touch EVERY 200 ms
END ENVIRONMENT
)";

const std::string hogging = R"(
MESSAGE correction : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE now : SIGNAL
MESSAGE raw : SIGNAL
MESSAGE tick : SIGNAL
CONDITION c
DEVICE robot
SKILL odd
  SENSOR DRIVER SD1
  LOGICAL SENSOR LS1
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r0 : RESPONSE FROM tick OF robot TO TXM( correction to robot ) AT MOST 1 s
END SKILL
Machine Controller: MC1
  ACTIVITY obey
BEGIN
  REPEAT
    WTM( tick from robot )
    obey
    TXM( correction to robot )
  UNTIL( forever )
END
Sensor Driver: SD1
Logical Sensor: LS1
  ACTIVITY think
BEGIN
  REPEAT
    TXM( request raw from SD1 )
    think
    WTM( raw from SD1 )
    TXM( now to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( now from LS1 )
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P NONPREEMPTIVE
  PROCESSOR Q
  PLACE MC1 ON P PRIORITY 4
  PLACE LS1 ON P PRIORITY 2
  PLACE SM1 ON Q PRIORITY 3
  TIME obey : 1 ms
  TIME think : 5 ms
  DEVICE robot EVENT tick EVERY 20 ms
  DEVICE SD1 ON REQUEST 1 ms
END ENVIRONMENT
)";

const std::string passed_on = R"(
MESSAGE correction : SIGNAL
MESSAGE force : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE other : SIGNAL
MESSAGE tick : SIGNAL
MESSAGE touch : SIGNAL
CONDITION c
DEVICE robot
SKILL odd
  SENSOR DRIVER SD1
  LOGICAL SENSOR LS1, LS2
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r3 : BUSY PERIOD OF P AT MOST 1 s
END SKILL

Logical Sensor: LS1
BEGIN
  REPEAT
    WTM( request force from SM1 )
    TXM( force to SM1 )
  UNTIL( forever )
END
Machine Controller: MC1
  ACTIVITY obey
BEGIN
  REPEAT
    WTM( tick from robot )
    obey
    TXM( correction to robot )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY long
BEGIN
  WTM( Coordinator )
  CONCURRENT
  BEGIN
    TXM( request force from LS1 )
    REPEAT
      WTM( other from LS2 )
    UNTIL( forever )
  END
  BEGIN
    WTM( force from LS1 )
    long
    TXM( Completion Protocol 0 )
  END
  END CONCURRENT
END
Sensor Driver: SD1
Logical Sensor: LS2
BEGIN
  REPEAT
    TXM( request touch from SD1 )
    WTM( touch from SD1 )
    TXM( other to SM1 )
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P
  PROCESSOR Q
  PLACE MC1 ON P PRIORITY 4
  PLACE LS1 ON Q PRIORITY 3
  PLACE LS2 ON Q PRIORITY 3
  PLACE SM1 ON P PRIORITY 5
  TIME obey : 1 ms
  TIME long : 10 ms
  DEVICE robot EVENT tick EVERY 50 ms
  DEVICE SD1 ON REQUEST 1 ms
END ENVIRONMENT
)";

const std::string taken_away = R"(
MESSAGE correction : SIGNAL
MESSAGE force : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE raw : SIGNAL
MESSAGE tick : SIGNAL
CONDITION c
DEVICE robot
SKILL odd
  SENSOR DRIVER SD1
  LOGICAL SENSOR LS1
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r3 : BUSY PERIOD OF P AT MOST 1 s
END SKILL
Sensor Driver: SD1
Logical Sensor: LS1
BEGIN
  REPEAT
    WTM( request force from SM1 )
    TXM( request raw from SD1 )
    WTM( raw from SD1 )
    TXM( force to SM1 )
  UNTIL( forever )
END
Machine Controller: MC1
  ACTIVITY obey
BEGIN
  REPEAT
    WTM( tick from robot )
    obey
    TXM( correction to robot )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY long
BEGIN
  WTM( Coordinator )
  CONCURRENT
  BEGIN
    REPEAT
      TXM( request force from LS1 )
      WTM( force from LS1 )
      SPC( c )
    UNTIL( forever )
  END
  BEGIN
    long
    WTM( force from LS1 )
    long
    TXM( Completion Protocol 0 )
  END
  END CONCURRENT
END
ENVIRONMENT cell
  PROCESSOR P
  PROCESSOR Q
  PLACE MC1 ON P PRIORITY 4
  PLACE LS1 ON Q PRIORITY 3
  PLACE SM1 ON P PRIORITY 5
  TIME obey : 1 ms
  TIME long : 10 ms
  DEVICE robot EVENT tick EVERY 50 ms
  DEVICE SD1 ON REQUEST 1 ms
END ENVIRONMENT
)";

const std::string withdrawn = R"(
MESSAGE correction : SIGNAL
MESSAGE force : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE tick : SIGNAL
CONDITION c
DEVICE robot
SKILL odd
  LOGICAL SENSOR LS1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r0 : DURATION TO COMPLETION 0 AT MOST 1 s
END SKILL
Logical Sensor: LS1
  ACTIVITY think
BEGIN
  REPEAT
    WTM( request force from SM1 )
    think
    TXM( force to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  CONCURRENT
  BEGIN
    TXM( request force from LS1 )
    WTM( force from LS1 ) WITHIN 5 ms
      Do Nothing
    ELSE
      Do Nothing
    END WTM
  END
  BEGIN
    WTM( force from LS1 ) WITHIN 5.5 ms
      Do Nothing
    ELSE
      Do Nothing
    END WTM
  END
  END CONCURRENT
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P
  PROCESSOR Q
  PROCESSOR R
  PLACE LS1 ON Q PRIORITY 3
  PLACE SM1 ON P PRIORITY 5
  PLACE SM1.2 ON R PRIORITY 5
  TIME think : 4.3 ms
  COST RECEIVE 1 ms
  COST TEST 1 ms
END ENVIRONMENT
)";

const std::string left = R"(
MESSAGE correction : SIGNAL
MESSAGE force : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE raw : SIGNAL
MESSAGE tick : SIGNAL
CONDITION c
DEVICE robot
SKILL odd
  SENSOR DRIVER SD1
  LOGICAL SENSOR LS1
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r0 : AGE OF raw FROM SD1 AT obey IN SM1 AT MOST 1 s
  REQUIREMENT r5 : BUSY PERIOD OF R AT MOST 1 s
END SKILL
Sensor Driver: SD1
Logical Sensor: LS1
BEGIN
  REPEAT
    WTM( request force from SM1 )
    TXM( request raw from SD1 )
    WTM( raw from SD1 )
    TXM( force to SM1 )
  UNTIL( forever )
END
Machine Controller: MC1
BEGIN
  REPEAT
    WTM( tick from robot )
    TXM( request motion from SM1 )
    WTM( motion from SM1 )
    TXM( correction to robot )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY think
  ACTIVITY obey
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( request motion from MC1 )
    think
    CASE
      ( c ):
         WTM( force from LS1 )
         obey
         SPC( c = FALSE )
      ( NOT c ):
         TXM( request force from LS1 )
         SPC( c = TRUE )
    END CASE
    TXM( motion to MC1 )
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P
  PROCESSOR Q
  PROCESSOR R
  PLACE LS1 ON Q PRIORITY 3
  PLACE MC1 ON P PRIORITY 5
  PLACE SM1 ON R PRIORITY 5
  TIME think : 1 ms
  TIME obey : 0.5 ms
  DEVICE robot EVENT tick EVERY 20 ms
  DEVICE SD1 ON REQUEST 2 TO 3 ms
END ENVIRONMENT
)";

const std::string asked_once = R"(
MESSAGE correction : SIGNAL
MESSAGE force : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE raw : SIGNAL
MESSAGE tick : SIGNAL
SKILL odd
  SENSOR DRIVER SD1
  LOGICAL SENSOR LS1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r0 : LOSS OF SD1 AT MOST 1 IN 3
END SKILL
Sensor Driver: SD1
Logical Sensor: LS1
BEGIN
  TXM( request raw from SD1 )
  WTM( raw from SD1 )
  REPEAT
    WTM( request force from SM1 )
    TXM( force to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY think
BEGIN
  WTM( Coordinator )
  REPEAT
    TXM( request force from LS1 )
    WTM( force from LS1 )
    think
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P
  PLACE LS1 ON P PRIORITY 2
  PLACE SM1 ON P PRIORITY 1
  TIME think : 1 ms
  DEVICE SD1 FRAMES EVERY 8 ms COLLECTING 4 ms
END ENVIRONMENT
)";

const std::string never_begun = R"(
MESSAGE correction : SIGNAL
MESSAGE force : SIGNAL
MESSAGE go : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE tick : SIGNAL
CONDITION c
CONDITION d
DEVICE robot
SKILL odd
  LOGICAL SENSOR LS1
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r0 : REACTION OF c AT work IN SM1 AT MOST 1 s
END SKILL
Logical Sensor: LS1
  ACTIVITY think
BEGIN
  WTM( request force from SM1 )
  CASE
    ( d ):
      TXM( go to SM1 )
    ( NOT d ):
      think
  END CASE
  TXM( force to SM1 )
END
Machine Controller: MC1
BEGIN
  REPEAT
    WTM( tick from robot )
    SPC( c )
    SPC( d )
    TXM( correction to robot )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  TXM( request force from LS1 )
  WTM( go from LS1 )
  CONCURRENT
  BEGIN
    work
  END
  END CONCURRENT
  WTM( force from LS1 )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P
  PLACE MC1 ON P PRIORITY 4
  PLACE LS1 ON P PRIORITY 3
  PLACE SM1 ON P PRIORITY 5
  TIME work : 1 ms
  TIME think : 1 ms
  DEVICE robot EVENT tick EVERY 50 ms
END ENVIRONMENT
)";

const std::string never_taken = R"(
MESSAGE correction : SIGNAL
MESSAGE force : SIGNAL
MESSAGE go : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE tick : SIGNAL
MESSAGE touch : SIGNAL
CONDITION c
CONDITION d
DEVICE robot
SKILL odd
  SENSOR DRIVER SD1
  LOGICAL SENSOR LS1, LS2
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r1 : REACTION OF touch FROM SD1 AT work IN SM1 AT MOST 1 s
END SKILL
Logical Sensor: LS1
  ACTIVITY think
BEGIN
  WTM( request force from SM1 )
  CASE
    ( d ):
      TXM( go to SM1 )
    ( NOT d ):
      think
  END CASE
  TXM( force to SM1 )
END
Logical Sensor: LS2
BEGIN
  REPEAT
    WTM( touch from SD1 )
    TXM( touch to SM1 )
  UNTIL( forever )
END
Sensor Driver: SD1
Machine Controller: MC1
BEGIN
  REPEAT
    WTM( tick from robot )
    SPC( c )
    SPC( d )
    TXM( correction to robot )
    
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  TXM( request force from LS1 )
  WTM( go from LS1 )
  CONCURRENT
  BEGIN
    REPEAT
      WTM( touch from LS2 )
      work
    UNTIL( forever )
  END
  END CONCURRENT
  WTM( force from LS1 )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P
  PLACE LS2 ON P PRIORITY 4
  DEVICE SD1 EVENT touch EVERY 70 ms
  PLACE MC1 ON P PRIORITY 4
  PLACE LS1 ON P PRIORITY 3
  PLACE SM1 ON P PRIORITY 5
  TIME work : 1 ms
  TIME think : 1 ms
  DEVICE robot EVENT tick EVERY 50 ms
END ENVIRONMENT
)";

const std::string later_rounds = R"(
MESSAGE correction : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE tick : SIGNAL
CONDITION c
DEVICE robot
SKILL odd
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r0 : AGE OF c AT obey IN MC1 AT MOST 1 s
END SKILL
Machine Controller: MC1
  ACTIVITY obey
BEGIN
  RPC( c )
  TXM( request motion from SM1 )
  REPEAT
    WTM( tick from robot )
    WTM( motion from SM1 )
    obey
    SPC( c )
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( request motion from MC1 )
    TXM( motion to MC1 )
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P
  PLACE MC1 ON P PRIORITY 4
  PLACE SM1 ON P PRIORITY 5
  TIME obey : 1 ms
  DEVICE robot EVENT tick EVERY 70 ms
END ENVIRONMENT
)";

const std::string elsewhere = R"(
MESSAGE correction : SIGNAL
MESSAGE force : SIGNAL
MESSAGE motion : SIGNAL
MESSAGE tick : SIGNAL
MESSAGE go : SIGNAL
CONDITION c
DEVICE robot
SKILL odd
  LOGICAL SENSOR LS1
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r0 : REACTION OF c AT work IN LS1 AT MOST 1 s
END SKILL
Logical Sensor: LS1
  ACTIVITY work
  ACTIVITY other
BEGIN
  SPC( c )
  work
  REPEAT
    WTM( request force from SM1 )
    CONCURRENT
    BEGIN
      work
    END
    BEGIN
      other
    END
    END CONCURRENT
    RPC( c )
    TXM( force to SM1 )
  UNTIL( forever )
END
Machine Controller: MC1
BEGIN
  REPEAT
    WTM( tick from robot )
    TXM( go to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY think
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( go from MC1 )
    TXM( request force from LS1 )
    WTM( force from LS1 )
    think
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P
  PLACE LS1 ON P PRIORITY 4
  PLACE SM1 ON P PRIORITY 5
  TIME work : 1 ms
  PLACE MC1 ON P PRIORITY 3
  DEVICE robot EVENT tick EVERY 50 ms
  TIME think : 1 ms
  TIME other : 1 ms
END ENVIRONMENT
)";

/// Whether the compositional analysis says that it has no bound, and a run shows why.
void has_none(const std::string& text) {
  const auto skill = pal::test::any_skill(text);
  REQUIRE(skill->problem);
  const auto compositional = pal::analyzer::analyze_compositionally(*skill->problem);
  CHECK_FALSE(compositional.verdicts.front().bound);
  const auto exact = pal::analyzer::analyze(*skill->problem);
  CHECK(exact.verdicts.front().state != pal::analyzer::VerdictState::holds);
}

/// The same, where the greatest value in milliseconds is known.
void has_age(const std::string& text, int exact_value) {
  const auto skill = pal::test::any_skill(text);
  REQUIRE(skill->problem);
  CHECK_FALSE(pal::analyzer::analyze_compositionally(*skill->problem).verdicts.front().bound);
  CHECK(pal::test::milliseconds(pal::analyzer::analyze(*skill->problem).verdicts.front()) == exact_value);
}

}  // namespace

TEST_CASE("what comes after a block waits for what that block has kept from the processor") {
  // The controller obeys from 0; the block has the processor from 0.5 to 25.5. Then there are 8.5 ms of the
  // first tick left, and two more ticks have come.
  compare(preempted, {{87.5, 53.5}});
}

TEST_CASE("a send that waits for its slot makes what was read before it older") {
  // The first motion is taken only after the 45 ms that MC3 works; the next one is put 30 ms after it.
  compare(held, {{15, 15}});
}

TEST_CASE("a thread that finds each answer there keeps a processor that is not preemptive") {
  // The answer comes after 1 ms of the 5 that LS1 thinks.
  compare(hogging, {{-1, -1}});
}

TEST_CASE("an answer that another block waits for begins work") {
  // SM1.1 asks, SM1.2 takes the answer and works for 10 ms.
  compare(passed_on, {{11, 10}});
}

TEST_CASE("an answer may be taken by a block that has not asked for it") {
  // Once in its life SM1.2 takes what SM1.1 asked for, and works for 10 ms more; MC1 obeys after that.
  compare(taken_away, {{-1, 21}});
}

TEST_CASE("a limit counts anew if what a thread is about to take is withdrawn") {
  // SM1.1 gives up at 6 what SM1.2 is taking until 6.3. From then SM1.2 waits 5.5 again, and gives up in 1.
  compare(withdrawn, {{-1, 12.8}});
}

TEST_CASE("an answer that a round leaves is taken by the next") {
  // What SM1 asks for in one round it takes in the next, 20 ms later.
  compare(left, {{-1, 20.5}, {11.5, 1.5}});
}

TEST_CASE("frames that nobody asks for any more are lost") {
  // LS1 asks once, at the start.
  has_none(asked_once);
}

TEST_CASE("a block that does not begin reacts to nothing") {
  // SM1 waits for what LS1 need not send; the first set, and the first sample, are then never reflected.
  has_none(never_begun);
  has_none(never_taken);
}

TEST_CASE("what a thread began before its rounds may come after it has come home") {
  // MC1 takes what it asked for at its start in its first round.
  has_age(later_rounds, 71);
}

TEST_CASE("a reaction goes on where another thread comes to its statement") {
  // LS1 has worked at its start, and its block works on; neither has read what was set.
  has_none(elsewhere);
}
