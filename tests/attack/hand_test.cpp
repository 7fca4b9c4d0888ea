// Programs that nobody would write, each with what docs/execution-model.md says of it, worked out by hand.
#include "analyzer/analysis.hpp"
#include "tests/attack/by_hand.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::bound;
using pal::test::cell;

namespace {

const std::string answer = "RESPONSE FROM tick OF robot TO TXM( correction to robot )";

}  // namespace

TEST_CASE("a CONCURRENT after one that ended by cancelling is waited for") {
  // The first is over at 1 ms, the second 5 ms later: the value of c, from the start, is 6 ms old then.
  CHECK(bound(cell(
            "AGE OF c AT TXM( motion to MC1 ) IN SM1", R"(Machine Controller: MC1
BEGIN
  WTM( motion from SM1 )
  TXM( request motion from SM1 )
END
Skill Module: SM1
  ACTIVITY short
  ACTIVITY long
BEGIN
  WTM( Coordinator )
  RPC( c )
  CONCURRENT
  BEGIN
    REPEAT
      WTM( request motion from MC1 )
    UNTIL( forever )
  END
  BEGIN
    short
  END
  END CONCURRENT
  CONCURRENT
  BEGIN
    long
  END
  END CONCURRENT
  TXM( motion to MC1 )
  TXM( Completion Protocol 0 )
END
)",
            "  PROCESSOR P\n  PLACE SM1 ON P PRIORITY 1\n  PLACE MC1 ON P PRIORITY 1\n  TIME short : 1 ms\n"
            "  TIME long : 5 ms\n")) == 6);
}

TEST_CASE("a wait that only looks may come before the message of a sender that its own take has freed") {
  // SM1 is always blocked in its send. The first wait of MC1 frees the slot and reaches the second, at one
  // instant with the send: it may miss it, and hold for 3 ms.
  CHECK(bound(cell(answer, R"(Machine Controller: MC1
  ACTIVITY hold
BEGIN
  REPEAT
    WTM( tick from robot )
    WTM( motion from SM1 )
    WTM( motion from SM1 ) WITHIN 0 ms
      Do Nothing
    ELSE
      hold
    END WTM
    TXM( correction to robot )
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  REPEAT
    TXM( motion to MC1 )
  UNTIL( forever )
END
)",
                   "  PROCESSOR P\n  PROCESSOR Q\n  PLACE SM1 ON P PRIORITY 1\n  PLACE MC1 ON Q PRIORITY 1\n"
                   "  TIME hold : 3 ms\n  DEVICE robot EVENT tick EVERY 20 ms PHASE 5 ms\n")) == 3);
}

TEST_CASE("a module that begins with blocks comes to their queues in any order with other modules") {
  // SM1's block (3 ms), MC1 (1 ms) and nobody else are on P: c, from the start, is 4 ms old if MC1 was first.
  CHECK(
      bound(cell("AGE OF c AT TXM( motion to MC1 ) IN SM1", R"(Skill Module: SM1
  ACTIVITY long
BEGIN
  WTM( Coordinator )
  CONCURRENT
  BEGIN
    long
    RPC( c )
    TXM( motion to MC1 )
  END
  END CONCURRENT
  TXM( Completion Protocol 0 )
END
Machine Controller: MC1
  ACTIVITY short
BEGIN
  short
  WTM( motion from SM1 )
END
)",
                 "  PROCESSOR P\n  PROCESSOR Q\n  PLACE SM1 ON Q PRIORITY 1\n  PLACE SM1.1 ON P PRIORITY 1\n"
                 "  PLACE MC1 ON P PRIORITY 1\n  TIME short : 1 ms\n  TIME long : 3 ms\n")) == 4);
}

TEST_CASE("times near the limit do not overflow") {
  // The condition is set once, before a loop without end: its age has no bound.
  std::string modules =
      "Machine Controller: MC1\nBEGIN\n  REPEAT\n    WTM( motion from SM1 )\n  UNTIL( forever )\nEND\n"
      "Skill Module: SM1\n  ACTIVITY long\nBEGIN\n  WTM( Coordinator )\n  SPC( c = TRUE )\n  REPEAT\n";
  for (int i = 0; i < 60; ++i) modules += "    long\n";
  modules += "    RPC( c )\n    TXM( motion to MC1 )\n  UNTIL( forever )\nEND\n";
  const auto skill = test::any_skill(cell(
      "AGE OF c AT TXM( motion to MC1 ) IN SM1", modules,
      "  PROCESSOR P\n  PLACE SM1 ON P PRIORITY 2\n  PLACE MC1 ON P PRIORITY 1\n  TIME long : 1000000 s\n"));
  REQUIRE(skill->problem);
  const Analysis analysis = analyze(*skill->problem);
  const Verdict& verdict = analysis.verdicts.front();
  INFO(verdict.explanation);
  CHECK_FALSE(verdict.bound);
  CHECK(verdict.state != Verdict::State::holds);
}

namespace {

/// SM1 interrupts MC1 1 ms after that has begun to obey, and never lets it go on.
std::string starving(const std::string& think) {
  return cell("AGE OF c AT think IN SM1", R"(Machine Controller: MC1
  ACTIVITY obey
BEGIN
  TXM( request motion from SM1 )
  obey
  WTM( motion from SM1 )
END
Skill Module: SM1
  ACTIVITY think
BEGIN
  WTM( Coordinator )
  WTM( request motion from MC1 )
  TXM( motion to MC1 )
  REPEAT
    SPC( c )
    RPC( c )
    think
  UNTIL( forever )
END
)",
              "  PROCESSOR P\n  PLACE SM1 ON P PRIORITY 2\n  PLACE MC1 ON P PRIORITY 1\n  TIME obey : 10 ms\n"
              "  TIME think : " +
                  think + "\n  LATENCY WITHIN PROCESSOR 1 ms\n");
}

}  // namespace

TEST_CASE("a thread that is interrupted for ever does not keep the exploration from its end") {
  CHECK(bound(starving("1 ms")) == 1);
  CHECK(bound(starving("1 TO 3 ms")) == 3);
}

TEST_CASE("an interrupted thread that interrupts another still owes it its time") {
  // MC1.1 obeys from 0; SM1.1 interrupts it at 1 for 5 ms, and is interrupted at 4 by MC1.2 for up to 2.
  // MC1.1 has its last millisecond from 8 on.
  CHECK(
      bound(cell("AGE OF c AT TXM( correction to robot )", R"(Machine Controller: MC1
  ACTIVITY obey
  ACTIVITY hold
BEGIN
  CONCURRENT
  BEGIN
    RPC( c )
    obey
    TXM( correction to robot )
  END
  BEGIN
    REPEAT
      WTM( tick from robot )
      hold
    UNTIL( forever )
  END
  END CONCURRENT
  WTM( motion from SM1 )
END
Skill Module: SM1
  ACTIVITY start
  ACTIVITY think
  ACTIVITY rest
BEGIN
  WTM( Coordinator )
  start
  CONCURRENT
  BEGIN
    think
  END
  END CONCURRENT
  rest
  TXM( motion to MC1 )
  TXM( Completion Protocol 0 )
END
)",
                 "  PROCESSOR P\n  PROCESSOR Q\n  PLACE SM1 ON Q PRIORITY 2\n  PLACE SM1.1 ON P PRIORITY 2\n"
                 "  PLACE MC1 ON P PRIORITY 1\n  PLACE MC1.2 ON P PRIORITY 3\n  TIME start : 1 ms\n  TIME "
                 "rest : 50 ms\n  TIME "
                 "think : 5 ms\n"
                 "  TIME obey : 2 ms\n  TIME hold : 1 TO 2 ms\n"
                 "  DEVICE robot EVENT tick EVERY 100 ms PHASE 4 ms\n")) == 9);
}

namespace {

/// MC1 asks SM1 for motions, and obeys at the end.
std::string asking(const std::string& client, const std::string& server) {
  return cell(
      "AGE OF c AT obey IN MC1",
      "Machine Controller: MC1\n  ACTIVITY obey\n  ACTIVITY hold\n  ACTIVITY rest\nBEGIN\n  RPC( c )\n" +
          client + "  obey\nEND\nSkill Module: SM1\n  ACTIVITY think\nBEGIN\n  WTM( Coordinator )\n" +
          server + "END\n",
      "  PROCESSOR P\n  PROCESSOR Q\n  PLACE SM1 ON Q PRIORITY 1\n  PLACE MC1 ON P PRIORITY 1\n"
      "  TIME think : 5 ms\n  TIME obey : 0 ms\n  TIME hold : 1 ms\n  TIME rest : 2 ms\n"
      "  DEVICE robot EVENT tick EVERY 1000 ms PHASE 500 ms\n");
}

const std::string serves =
    "  REPEAT\n    WTM( request motion from MC1 )\n    think\n    TXM( motion to MC1 )\n  UNTIL( forever )\n";

}  // namespace

TEST_CASE("a block that is cancelled takes back what it has asked for, and not what its parent has") {
  // The block asks at 1 ms, and is cancelled at 3; the answer to its parent comes at 5.
  CHECK(bound(asking(R"(  TXM( request motion from SM1 )
  CONCURRENT
  BEGIN
    REPEAT
      hold
      TXM( request motion from SM1 )
      WTM( motion from SM1 )
    UNTIL( forever )
  END
  BEGIN
    rest
  END
  END CONCURRENT
  WTM( motion from SM1 )
)",
                     serves)) == 5);
}

TEST_CASE("what a block has open when it ends is taken back with its parent") {
  // The inner block has asked at 0, its parent is stopped at 1: the answer of 5 ms is discarded, and the next
  // request answered at 10.
  CHECK(bound(asking(R"(  CONCURRENT
  BEGIN
    REPEAT
      CONCURRENT
      BEGIN
        TXM( request motion from SM1 )
      END
      END CONCURRENT
      rest
    UNTIL( forever )
  END
  BEGIN
    hold
  END
  END CONCURRENT
  TXM( request motion from SM1 )
  WTM( motion from SM1 )
)",
                     serves)) == 10);
}

TEST_CASE("of two requests that were taken the one that was withdrawn is not answered") {
  // Both are taken at 0, the second is withdrawn at 2. Of the answers at 5 one is put; the next message comes
  // at 10.
  CHECK(bound(asking(R"(  TXM( request motion from SM1 )
  CONCURRENT
  BEGIN
    TXM( request motion from SM1 )
    REPEAT
      WTM( tick from robot )
    UNTIL( forever )
  END
  BEGIN
    rest
  END
  END CONCURRENT
  WTM( motion from SM1 )
  WTM( motion from SM1 )
)",
                     "  WTM( request motion from MC1 )\n  WTM( request motion from MC1 )\n  think\n"
                     "  TXM( motion to MC1 )\n  TXM( motion to MC1 )\n  think\n  TXM( motion to MC1 )\n")) ==
        10);
}

TEST_CASE("a request whose answer was lost is not open any more") {
  // The device answers at 1 and, into the full slot, at 2: that one is lost. After both waits nothing is
  // open, so the answer to the third request is not discarded: it comes 1 ms after 7.
  const std::string text =
      cell("AGE OF c AT TXM( motion to MC1 ) IN SM1", R"(Machine Controller: MC1
BEGIN
  WTM( motion from SM1 )
END
Sensor Driver: SD1
Logical Sensor: LS1
  ACTIVITY extract
BEGIN
  TXM( request raw from SD1 )
  TXM( request raw from SD1 )
  extract
  WTM( raw from SD1 )
  WTM( raw from SD1 ) WITHIN 2 ms
    extract
  ELSE
    Do Nothing
  END WTM
  TXM( request raw from SD1 )
  WTM( raw from SD1 )
  TXM( force to SM1 )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  RPC( c )
  WTM( force from LS1 )
  TXM( motion to MC1 )
  TXM( Completion Protocol 0 )
END
)",
           "  PROCESSOR P\n  PROCESSOR Q\n  PLACE SM1 ON Q PRIORITY 1\n  PLACE MC1 ON Q PRIORITY 1\n"
           "  PLACE LS1 ON P PRIORITY 1\n  TIME extract : 5 ms\n  DEVICE SD1 ON REQUEST 1 ms\n");
  const std::string sensors = "  SENSOR DRIVER SD1\n  LOGICAL SENSOR LS1\n  MACHINE CONTROLLER MC1";
  std::string whole = "MESSAGE raw : SIGNAL\nMESSAGE force : SIGNAL\n" + text;
  whole.replace(whole.find("  MACHINE CONTROLLER MC1"), std::string("  MACHINE CONTROLLER MC1").size(),
                sensors);
  CHECK(bound(whole) == 8);
}

TEST_CASE("the parent of a stopped block may go on before a sender whose slot the withdrawal has freed") {
  // At 2 ms the answer to the block is withdrawn, and the second message of SM1 put. Then SM1 and MC1 come to
  // P: if MC1 is first it holds for 1 ms, and SM1 has thought from 3 to 8.
  CHECK(bound(cell(
            "AGE OF c AT think IN SM1", R"(Machine Controller: MC1
  ACTIVITY hold
  ACTIVITY rest
BEGIN
  CONCURRENT
  BEGIN
    TXM( request motion from SM1 )
    REPEAT
      WTM( tick from robot )
    UNTIL( forever )
  END
  BEGIN
    rest
  END
  END CONCURRENT
  hold
  WTM( motion from SM1 )
END
Skill Module: SM1
  ACTIVITY think
BEGIN
  WTM( Coordinator )
  RPC( c )
  WTM( request motion from MC1 )
  TXM( motion to MC1 )
  TXM( motion to MC1 )
  think
END
)",
            "  PROCESSOR P\n  PROCESSOR R\n  PLACE SM1 ON P PRIORITY 1\n  PLACE MC1 ON P PRIORITY 1\n"
            "  PLACE MC1.2 ON R PRIORITY 1\n  TIME think : 5 ms\n  TIME hold : 1 ms\n  TIME rest : 2 ms\n"
            "  DEVICE robot EVENT tick EVERY 1000 ms PHASE 500 ms\n")) == 8);
}

TEST_CASE("a thread that waits for its processor for ever does not take it in another processor's load") {
  // MC2 never gives P0 to SM1, which would complete the skill at once; P1 is busy with MC1 all the time.
  std::string text =
      cell("LOAD OF P1", R"(Machine Controller: MC1
  ACTIVITY long
BEGIN
  REPEAT
    long
  UNTIL( forever )
END
Machine Controller: MC2
  ACTIVITY short
BEGIN
  REPEAT
    short
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  TXM( Completion Protocol 0 )
END
)",
           "  PROCESSOR P0\n  PROCESSOR P1\n  PLACE SM1 ON P0 PRIORITY 1\n  PLACE MC1 ON P1 PRIORITY 1\n"
           "  PLACE MC2 ON P0 PRIORITY 1\n  TIME short : 2 ms\n  TIME long : 3 ms\n");
  const std::string limit = "AT MOST 1 s";
  text.replace(text.find(limit), limit.size(), "AT MOST 50 %");
  const auto skill = pal::test::any_skill(text);
  INFO(text << pal::test::messages(skill->diagnostics));
  REQUIRE(skill->problem);
  const Verdict verdict = analyze(*skill->problem).verdicts.front();
  CHECK(verdict.state == Verdict::State::fails);
  CHECK(verdict.exact);
  CHECK(verdict.bound == Duration(1'000'000'000));
}

TEST_CASE("nothing holds of a skill in which time may stand still, however soon the proof is ended") {
  // MC1 and SM1 hand the one message on at one instant, for as long as c stays FALSE.
  const auto skill =
      pal::test::any_skill(cell("DURATION TO COMPLETION 0", R"(Machine Controller: MC1
BEGIN
  REPEAT
    TXM( request motion from SM1 )
    WTM( motion from SM1 )
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( request motion from MC1 )
    TXM( motion to MC1 )
    SPC( c )
  UNTIL( c )
  TXM( Completion Protocol 0 )
END
)",
                                "  PROCESSOR P\n  PLACE SM1 ON P PRIORITY 1\n  PLACE MC1 ON P PRIORITY 1\n"));
  INFO(pal::test::messages(skill->diagnostics));
  REQUIRE(skill->problem);
  int asked = 0;
  for (int most = 0; most < 40; ++most) {
    asked = 0;
    Options options;
    options.threads = 1;
    options.stop = [&asked, most] { return ++asked > most; };
    const Analysis analysis = analyze(*skill->problem, AnalysisChoice::automatic, options);
    INFO(most);
    CHECK(analysis.verdicts.front().state != Verdict::State::holds);
    if (asked <= most) CHECK(analysis.standstill.has_value());
  }
}

TEST_CASE("what is not answered when the skill ends is not counted, however long it has grown") {
  // The event of MC1 is unanswered for eight rounds of 70 ms, more than is followed exactly; then the skill
  // ends, in every run.
  const auto skill = pal::test::any_skill(
      cell("RESPONSE FROM motion OF MC1 TO early IN SM1", R"(Machine Controller: MC1
BEGIN
  REPEAT
    WTM( request motion from SM1 )
    TXM( motion to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY early
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  early
  TXM( request motion from MC1 )
  WTM( motion from MC1 )
  REPEAT
    work
    CASE
      ( NOT a ):
        SPC( a = TRUE )
      ( a AND NOT b ):
        SPC( b = TRUE )
        SPC( a = FALSE )
      ( a AND b AND NOT c ):
        SPC( c = TRUE )
        SPC( b = FALSE )
        SPC( a = FALSE )
      ( a AND b AND c ):
        SPC( d = TRUE )
    END CASE
  UNTIL( d )
  TXM( Completion Protocol 0 )
END
CONDITION a
CONDITION b
CONDITION d
)",
           "  PROCESSOR P\n  PLACE SM1 ON P PRIORITY 1\n  PLACE MC1 ON P PRIORITY 1\n  TIME early : 1 ms\n"
           "  TIME work : 70 ms\n"));
  INFO(pal::test::messages(skill->diagnostics));
  REQUIRE(skill->problem);
  Problem problem = *skill->problem;
  problem.requirements.front().limit = 20'000'000;
  const Verdict verdict = analyze(problem).verdicts.front();
  INFO(verdict.explanation);
  CHECK(verdict.state == Verdict::State::never);
}

TEST_CASE("what waits for an event that need not come grows for ever") {
  // After motion SM1 waits for a tick, then ends the skill without an answer. The tick may never come.
  const auto skill = pal::test::any_skill(
      cell("RESPONSE FROM motion OF MC1 TO early IN SM1", R"(Machine Controller: MC1
BEGIN
  WTM( request motion from SM1 )
  TXM( motion to SM1 )
  WTM( request correction from SM1 )
  WTM( tick from robot )
  TXM( correction to SM1 )
END
Skill Module: SM1
  ACTIVITY early
BEGIN
  WTM( Coordinator )
  early
  TXM( request motion from MC1 )
  WTM( motion from MC1 )
  TXM( request correction from MC1 )
  WTM( correction from MC1 )
  TXM( Completion Protocol 0 )
END
)",
           "  PROCESSOR P\n  PLACE SM1 ON P PRIORITY 1\n  PLACE MC1 ON P PRIORITY 1\n  TIME early : 1 ms\n"
           "  DEVICE robot EVENT tick SPORADIC 10 ms\n"));
  INFO(pal::test::messages(skill->diagnostics));
  REQUIRE(skill->problem);
  const Verdict verdict = analyze(*skill->problem).verdicts.front();
  INFO(verdict.explanation);
  CHECK(verdict.state == Verdict::State::fails);
}

TEST_CASE("what has grown beyond all that is followed when a skill stands still grows for ever") {
  // SM1 goes round eight times, and then waits for an answer that the device has lost.
  const auto skill = pal::test::any_skill(
      cell("RESPONSE FROM motion OF MC1 TO early IN SM1", R"(Machine Controller: MC1
  ACTIVITY sleep
BEGIN
  REPEAT
    WTM FIRST
      ( request motion from SM1 ):
        TXM( motion to SM1 )
      ( request correction from SM1 ):
        TXM( request correction from robot )
        TXM( request correction from robot )
        sleep
        WTM( correction from robot )
        WTM( correction from robot )
        TXM( correction to SM1 )
    END WTM
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY early
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  early
  TXM( request motion from MC1 )
  WTM( motion from MC1 )
  REPEAT
    work
    CASE
      ( NOT a ):
        SPC( a = TRUE )
      ( a AND NOT b ):
        SPC( b = TRUE )
        SPC( a = FALSE )
      ( a AND b AND NOT c ):
        SPC( c = TRUE )
        SPC( b = FALSE )
        SPC( a = FALSE )
      ( a AND b AND c ):
        SPC( d = TRUE )
    END CASE
  UNTIL( d )
  TXM( request correction from MC1 )
  WTM( correction from MC1 )
  TXM( Completion Protocol 0 )
END
CONDITION a
CONDITION b
CONDITION d
)",
           "  PROCESSOR P\n  PLACE SM1 ON P PRIORITY 1\n  PLACE MC1 ON P PRIORITY 1\n  TIME early : 1 ms\n"
           "  TIME work : 70 ms\n  TIME sleep : 9 ms\n  DEVICE robot ON REQUEST 1 ms\n"));
  INFO(pal::test::messages(skill->diagnostics));
  REQUIRE(skill->problem);
  Problem problem = *skill->problem;
  problem.requirements.front().limit = 20'000'000;
  const Verdict verdict = analyze(problem).verdicts.front();
  INFO(verdict.explanation);
  CHECK(verdict.state == Verdict::State::fails);
}
