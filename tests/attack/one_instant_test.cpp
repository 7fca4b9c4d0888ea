// What happens at one instant happens in any order that causes allow: programs that depend on an order.
#include "tests/attack/by_hand.hpp"

using pal::test::bound;
using pal::test::cell;

namespace {

/// A skill with two controllers whose duration is asked for.
std::string program(const std::string& declarations, const std::string& modules,
                    const std::string& environment) {
  return declarations +
         "SKILL odd\n  MACHINE CONTROLLER MC1, MC2\n  SKILL METHOD SM1\n  COMPLETION 0 NORMAL\n"
         "  COMPLETION 2 ERROR\n  REQUIREMENT r : DURATION TO COMPLETION 0 AT MOST 1 s\nEND SKILL\n" +
         modules + "ENVIRONMENT cell\n" + environment + "END ENVIRONMENT\n";
}

}  // namespace

TEST_CASE("a device that becomes idle takes its next request before or after its answer is there") {
  // At 10 ms the answer a wakes MC1, and the request that is taken then lets MC2 go on, which was blocked in
  // its second one. They share a queue: MC1 may have to wait for the 5 ms of MC2.
  CHECK(bound(program("DEVICE d\nMESSAGE a : SIGNAL\nMESSAGE b : SIGNAL\nMESSAGE go : SIGNAL\n", R"(
Machine Controller: MC1
  ACTIVITY short
BEGIN
  REPEAT
    WTM( go from SM1 )
    TXM( request a from d )
    WTM( a from d )
    short
    TXM( go to SM1 )
  UNTIL( forever )
END
Machine Controller: MC2
  ACTIVITY long
BEGIN
  REPEAT
    WTM( go from SM1 )
    TXM( request b from d )
    TXM( request b from d )
    long
    WTM( b from d )
    WTM( b from d )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY pause
BEGIN
  WTM( Coordinator )
  TXM( go to MC1 )
  pause
  TXM( go to MC2 )
  WTM( go from MC1 )
  TXM( Completion Protocol 0 )
END
)",
                      R"(  PROCESSOR P
  PROCESSOR Q
  DEVICE d ON REQUEST 10 ms
  PLACE MC1 ON P PRIORITY 1
  PLACE MC2 ON P PRIORITY 1
  PLACE SM1 ON Q PRIORITY 1
  TIME pause : 1 ms
  TIME short : 1 ms
  TIME long : 5 ms
)")) == 16);
}

TEST_CASE("a wait that gives up goes on between two senders that it has freed") {
  // At 15 ms SM1 withdraws what it asked of MC1 and of MC2, of which each is blocked in a second answer. The
  // block that begins then may come to the queue between them, and find that one has set its condition and
  // the other has not.
  CHECK(bound(program("MESSAGE X : SIGNAL\nMESSAGE Y : SIGNAL\nCONDITION one\nCONDITION two\n", R"(
Machine Controller: MC1
BEGIN
  WTM( request X from SM1 )
  TXM( X to SM1 )
  TXM( X to SM1 )
  SPC( one = TRUE )
  REPEAT
    WTM( request X from SM1 )
  UNTIL( forever )
END
Machine Controller: MC2
BEGIN
  WTM( request Y from SM1 )
  TXM( Y to SM1 )
  TXM( Y to SM1 )
  SPC( two = TRUE )
  REPEAT
    WTM( request Y from SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY slow
BEGIN
  WTM( Coordinator )
  TXM( request X from MC1 )
  TXM( request Y from MC2 )
  WTM FIRST WITHIN 15 ms
    ( X from MC1 ):
      Do Nothing
    ( Y from MC2 ):
      Do Nothing
  ELSE
    Do Nothing
  END WTM
  CONCURRENT
  BEGIN
    CASE
      ( one AND NOT two ):
        slow
      ( NOT one OR two ):
        Do Nothing
    END CASE
  END
  END CONCURRENT
  TXM( Completion Protocol 0 )
END
)",
                      R"(  PROCESSOR P
  PROCESSOR Q
  PLACE MC1 ON P PRIORITY 1
  PLACE MC2 ON P PRIORITY 1
  PLACE SM1 ON Q PRIORITY 1
  PLACE SM1.1 ON P PRIORITY 1
  TIME slow : 50 ms
  LATENCY BETWEEN PROCESSORS 10 ms
)")) == 65);
}

TEST_CASE("behind a CONCURRENT the parent goes on before whoever was freed by any of its cancelled blocks") {
  // At 15 ms both other blocks are cancelled. The first has asked MC1 for X, and frees it by that; SM1 may
  // come to the queue before MC1 all the same, and test before MC1 sets.
  CHECK(bound(program("MESSAGE X : SIGNAL\nMESSAGE Y : SIGNAL\nCONDITION one\n", R"(
Machine Controller: MC1
BEGIN
  WTM( request X from SM1 )
  TXM( X to SM1 )
  TXM( X to SM1 )
  SPC( one = TRUE )
  REPEAT
    WTM( request X from SM1 )
  UNTIL( forever )
END
Machine Controller: MC2
BEGIN
  REPEAT
    WTM( request Y from SM1 )
    TXM( Y to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY slow
  ACTIVITY pause
BEGIN
  WTM( Coordinator )
  CONCURRENT
  BEGIN
    TXM( request X from MC1 )
    REPEAT
      WTM( X from MC1 )
    UNTIL( forever )
  END
  BEGIN
    REPEAT
      TXM( request Y from MC2 )
      WTM( Y from MC2 )
    UNTIL( forever )
  END
  BEGIN
    pause
  END
  END CONCURRENT
  CASE
    ( NOT one ):
      slow
    ( one ):
      Do Nothing
  END CASE
  TXM( Completion Protocol 0 )
END
)",
                      R"(  PROCESSOR P
  PROCESSOR Q
  PROCESSOR R
  PLACE MC1 ON P PRIORITY 1
  PLACE MC2 ON R PRIORITY 1
  PLACE SM1 ON P PRIORITY 1
  PLACE SM1.1 ON Q PRIORITY 1
  PLACE SM1.2 ON Q PRIORITY 1
  PLACE SM1.3 ON R PRIORITY 2
  TIME slow : 50 ms
  TIME pause : 15 ms
  LATENCY BETWEEN PROCESSORS 10 ms
)")) == 65);
}

TEST_CASE("a pause of no length need not end a busy period") {
  // P is idle while SM1 waits for the answer of MC1, which comes at the same instant.
  CHECK(bound(cell("BUSY PERIOD OF P", R"(Machine Controller: MC1
BEGIN
  REPEAT
    WTM( motion from SM1 )
    TXM( request motion from SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  work
  TXM( motion to MC1 )
  WTM( request motion from MC1 )
  work
  TXM( Completion Protocol 0 )
END
)",
                   "  PROCESSOR P\n  PROCESSOR Q\n  PLACE SM1 ON P PRIORITY 1\n  PLACE MC1 ON Q PRIORITY 1\n"
                   "  TIME work : 5 ms\n")) == 10);
}

TEST_CASE("a skill that ends during a pause of no length ends like any other") {
  // MC1 has P for 2 ms. At that instant SM1 completes, before the pause of P is over or after it.
  CHECK(bound(cell("BUSY PERIOD OF P", R"(Machine Controller: MC1
  ACTIVITY work
BEGIN
  WTM( motion from SM1 )
  work
  WTM( motion from SM1 )
END
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  TXM( motion to MC1 )
  work
  TXM( Completion Protocol 0 )
END
)",
                   "  PROCESSOR P\n  PROCESSOR Q\n  PLACE SM1 ON Q PRIORITY 1\n  PLACE MC1 ON P PRIORITY 1\n"
                   "  TIME work : 2 ms\n")) == 2);
}

TEST_CASE("a thread that is to stop does so before or after whoever is freed at that instant") {
  // At 15 ms SM1.2 gives up. That lets SM1.1 put its second request and end, which cancels SM1.2; and it
  // frees MC2, which is blocked in a second answer. SM1 may go on before MC2 comes to the queue and sets its
  // condition.
  CHECK(bound(program("MESSAGE X : SIGNAL\nMESSAGE Y : SIGNAL\nCONDITION one\n", R"(
Machine Controller: MC1
  ACTIVITY late
BEGIN
  late
  REPEAT
    WTM( request X from SM1 )
    TXM( X to SM1 )
  UNTIL( forever )
END
Machine Controller: MC2
BEGIN
  WTM( request Y from SM1 )
  TXM( Y to SM1 )
  TXM( Y to SM1 )
  SPC( one = TRUE )
  REPEAT
    WTM( request Y from SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY slow
  ACTIVITY pause
BEGIN
  WTM( Coordinator )
  TXM( request Y from MC2 )
  CONCURRENT
  BEGIN
    TXM( request X from MC1 )
    TXM( request X from MC1 )
  END
  BEGIN
    REPEAT
      WTM FIRST WITHIN 15 ms
        ( X from MC1 ):
          Do Nothing
        ( Y from MC2 ):
          Do Nothing
      ELSE
        Do Nothing
      END WTM
      pause
    UNTIL( forever )
  END
  END CONCURRENT
  CASE
    ( NOT one ):
      slow
    ( one ):
      Do Nothing
  END CASE
  TXM( Completion Protocol 0 )
END
)",
                      R"(  PROCESSOR P
  PROCESSOR Q
  PROCESSOR R
  PLACE MC1 ON R PRIORITY 1
  PLACE MC2 ON P PRIORITY 1
  PLACE SM1 ON P PRIORITY 1
  PLACE SM1.1 ON Q PRIORITY 1
  PLACE SM1.2 ON Q PRIORITY 1
  TIME late : 40 ms
  TIME slow : 50 ms
  TIME pause : 1 ms
  LATENCY BETWEEN PROCESSORS 20 ms
)")) == 65);
}

TEST_CASE("a stopped block's message is withdrawn before or after somebody else has stopped waiting for it") {
  // At 3 ms the inner loop is cancelled, for which X was there and which has not had the processor yet. What
  // it asked for is withdrawn: either SM1.1 never knows of X, and gives up at 6 ms, before c is set; or it
  // stops waiting for it, finds it withdrawn, and waits 5 ms more.
  CHECK(bound(program("MESSAGE X : SIGNAL\nCONDITION c\n", R"(
Machine Controller: MC1
  ACTIVITY busy
BEGIN
  WTM( request X from SM1 )
  TXM( X to SM1 )
  busy
  SPC( c = TRUE )
END
Machine Controller: MC2
BEGIN
  WTM( X from SM1 )
END
Skill Module: SM1
  ACTIVITY short
  ACTIVITY pause
  ACTIVITY slow
BEGIN
  WTM( Coordinator )
  CONCURRENT
  BEGIN
    short
    WTM( X from MC1 ) WITHIN 5 ms
      Do Nothing
    ELSE
      CASE
        ( c ):
          Do Nothing
        ( NOT c ):
          slow
      END CASE
    END WTM
  END
  BEGIN
    CONCURRENT
    BEGIN
      REPEAT
        TXM( request X from MC1 )
        WTM( X from MC1 )
      UNTIL( forever )
    END
    BEGIN
      pause
    END
    END CONCURRENT
  END
  END CONCURRENT
  TXM( X to MC2 )
  TXM( Completion Protocol 0 )
END
)",
                      R"(  PROCESSOR P
  PROCESSOR Q
  PROCESSOR R
  PLACE MC1 ON P PRIORITY 2
  PLACE MC2 ON R PRIORITY 1
  PLACE SM1 ON Q PRIORITY 1
  PLACE SM1.2 ON R PRIORITY 1
  PLACE SM1.3 ON P PRIORITY 1
  PLACE SM1.4 ON R PRIORITY 1
  TIME busy : 7 ms
  TIME short : 1 ms
  TIME pause : 3 ms
  TIME slow : 50 ms
)")) == 56);
}

TEST_CASE("of two stopped blocks one has asked for the message that the other was to take") {
  // As before; but the block that X was there for, SM1.3, is not the one that has asked for it, SM1.4.
  CHECK(bound(program("MESSAGE X : SIGNAL\nMESSAGE Y : SIGNAL\nCONDITION c\n", R"(
Machine Controller: MC1
  ACTIVITY busy
BEGIN
  WTM( request X from SM1 )
  TXM( X to SM1 )
  busy
  SPC( c = TRUE )
END
Machine Controller: MC2
BEGIN
  WTM( X from SM1 )
  TXM( Y to SM1 )
END
Skill Module: SM1
  ACTIVITY short
  ACTIVITY pause
  ACTIVITY slow
BEGIN
  WTM( Coordinator )
  CONCURRENT
  BEGIN
    short
    WTM( X from MC1 ) WITHIN 5 ms
      Do Nothing
    ELSE
      CASE
        ( c ):
          Do Nothing
        ( NOT c ):
          slow
      END CASE
    END WTM
  END
  BEGIN
    CONCURRENT
    BEGIN
      REPEAT
        WTM( X from MC1 )
      UNTIL( forever )
    END
    BEGIN
      TXM( request X from MC1 )
      REPEAT
        WTM( Y from MC2 )
      UNTIL( forever )
    END
    BEGIN
      pause
    END
    END CONCURRENT
  END
  END CONCURRENT
  TXM( X to MC2 )
  TXM( Completion Protocol 0 )
END
)",
                      R"(  PROCESSOR P
  PROCESSOR Q
  PROCESSOR R
  PLACE MC1 ON P PRIORITY 2
  PLACE MC2 ON R PRIORITY 1
  PLACE SM1 ON Q PRIORITY 1
  PLACE SM1.2 ON R PRIORITY 1
  PLACE SM1.3 ON P PRIORITY 1
  PLACE SM1.4 ON P PRIORITY 1
  PLACE SM1.5 ON R PRIORITY 1
  TIME busy : 7 ms
  TIME short : 1 ms
  TIME pause : 3 ms
  TIME slow : 50 ms
)")) == 56);
}

TEST_CASE("blocks behind blocks that are over at once share a queue with modules from the beginning") {
  // MC1 goes on to its second CONCURRENT at once. Its block may come to the queue of SM1 before SM1.
  CHECK(bound(program("MESSAGE go : SIGNAL\n", R"(
Machine Controller: MC1
  ACTIVITY work
BEGIN
  CONCURRENT
  BEGIN
    Do Nothing
  END
  END CONCURRENT
  CONCURRENT
  BEGIN
    work
  END
  END CONCURRENT
END
Machine Controller: MC2
BEGIN
  WTM( go from SM1 )
END
Skill Module: SM1
  ACTIVITY short
BEGIN
  WTM( Coordinator )
  TXM( go to MC2 )
  short
  TXM( Completion Protocol 0 )
END
)",
                      R"(  PROCESSOR P
  PROCESSOR Q
  PLACE MC1 ON Q PRIORITY 1
  PLACE MC1.2 ON P PRIORITY 1
  PLACE MC2 ON Q PRIORITY 2
  PLACE SM1 ON P PRIORITY 1
  TIME work : 5 ms
  TIME short : 7 ms
)")) == 12);
}
