// Programs that nobody would write, each with what docs/execution-model.md says of it, worked out by hand.
#include <catch2/catch.hpp>

#include "analyzer/exact.hpp"
#include "tests/support/any_skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

/// A skill with a controller MC1 whose robot ticks, its modules and its environment.
std::string cell(const std::string& requirement, const std::string& modules, const std::string& environment) {
  return "MESSAGE motion : SIGNAL\nMESSAGE correction : SIGNAL\nMESSAGE tick : SIGNAL\nCONDITION c\nDEVICE "
         "robot\n"
         "SKILL odd\n  MACHINE CONTROLLER MC1\n  SKILL METHOD SM1\n  COMPLETION 0 NORMAL\n  COMPLETION 1 "
         "ERROR\n"
         "  REQUIREMENT r : " +
         requirement + " AT MOST 1 s\nEND SKILL\n" + modules + "ENVIRONMENT cell\n" + environment +
         "END ENVIRONMENT\n";
}

/// Its bound in milliseconds, which must be exact; -1: it fails without one.
std::int64_t bound(const std::string& text) {
  const auto skill = test::any_skill(text);
  INFO(text << test::messages(skill->diagnostics));
  REQUIRE(skill->problem);
  const Analysis analysis = analyze(*skill->problem);
  const Verdict& verdict = analysis.verdicts.front();
  INFO(verdict.explanation);
  CHECK(verdict.exact);
  return verdict.bound ? verdict.bound->count() / 1'000'000 : -1;
}

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
