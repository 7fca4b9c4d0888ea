#include "analyzer/load.hpp"

#include <catch2/catch.hpp>

#include "analyzer/exact.hpp"
#include "tests/support/skill.hpp"
#include "tests/unit/analyzer/small_skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using test::small_skill;
using test::worker;

TEST_CASE("the load of a periodic worker is its work in its period") {
  const auto skill =
      test::sound_skill(small_skill("REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 40 %", worker,
                                    "PROCESSOR P0\nPROCESSOR P1\nDEVICE MC1 EVENT tick EVERY 12 ms\nTIME "
                                    "work : 1 TO 4 ms\nCOST SET 1 ms\nPLACE SM1 ON P1 PRIORITY 1\n"));
  const Verdict verdict = analyze(*skill->problem).verdicts.front();
  CHECK(verdict.state == Verdict::State::fails);
  CHECK(verdict.exact);
  REQUIRE(verdict.bound);
  CHECK(verdict.bound->count() == 416'666'667);  // 5 ms in 12 ms, rounded up
  CHECK(verdict.explanation.find("P1") != std::string::npos);
  REQUIRE(verdict.witness);
}

TEST_CASE("the load of a sporadic worker is at most its work in its least separation") {
  const auto skill = test::sound_skill(
      small_skill("REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 42 %", worker,
                  "PROCESSOR P0\nPROCESSOR P1\nDEVICE MC1 EVENT tick SPORADIC 12 ms JITTER 2 ms\nTIME "
                  "work : 1 TO 4 ms\nCOST SET 1 ms\nPLACE SM1 ON P1 PRIORITY 1\n"));
  const Verdict verdict = analyze(*skill->problem).verdicts.front();
  CHECK(verdict.state == Verdict::State::holds);
  REQUIRE(verdict.bound);
  CHECK(verdict.bound->count() == 416'666'667);  // 5 ms in 12 ms, rounded up
}

TEST_CASE("a load counts from the beginning on if the skill comes back to it") {
  // Each event may come when the work of the one before ends: always busy. What the skill comes back to
  // includes where it began, as the other block may be anywhere in its nap then.
  const auto skill = test::sound_skill(small_skill("REQUIREMENT load : LOAD OF P1 AT MOST 99 %", R"(
Skill Module: SM1
  ACTIVITY work
  ACTIVITY nap
BEGIN
  WTM( Coordinator )
  CONCURRENT
  BEGIN
    REPEAT
      WTM( tick from MC1 )
      work
    UNTIL( forever )
  END
  BEGIN
    REPEAT
      nap
    UNTIL( forever )
  END
  END CONCURRENT
END
)",
                                                   "PROCESSOR P0\nPROCESSOR P1\nDEVICE MC1 EVENT tick "
                                                   "SPORADIC 5 ms\nTIME work : 5 ms\nTIME nap : 29 ms\n"
                                                   "PLACE SM1 ON P1 PRIORITY 1\nPLACE SM1.2 ON P0 PRIORITY "
                                                   "1\n"));
  const Verdict verdict = analyze(*skill->problem).verdicts.front();
  CHECK(verdict.state != Verdict::State::holds);
  REQUIRE(verdict.bound);
  CHECK(verdict.bound->count() == 1'000'000'000);
}

TEST_CASE("a skill that always ends has no load") {
  const auto skill =
      test::sound_skill(small_skill("REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 0 %", R"(
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  work
  TXM( Completion Protocol 0 )
END
)",
                                    "PROCESSOR P0\nTIME work : 1 TO 4 ms\nPLACE SM1 ON P0 PRIORITY 1\n"));
  const Verdict verdict = analyze(*skill->problem).verdicts.front();
  CHECK(verdict.state == Verdict::State::holds);
  CHECK(verdict.bound == Duration(0));
}

TEST_CASE("a load is exact whatever the times have in common") {
  const auto skill = test::sound_skill(
      small_skill("REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 40 %", worker,
                  "PROCESSOR P0\nPROCESSOR P1\nDEVICE MC1 EVENT tick EVERY 12000001 ns\nTIME "
                  "work : 1 TO 3999999 ns\nCOST SET 999983 ns\nPLACE SM1 ON P1 PRIORITY 1\n"));
  Options options;
  options.max_states = 5'000;  // far fewer than there are nanoseconds
  const Verdict verdict = analyze(*skill->problem, options).verdicts.front();
  CHECK(verdict.state == Verdict::State::fails);
  CHECK(verdict.exact);
  REQUIRE(verdict.bound);
  CHECK(verdict.bound->count() == 416'665'132);  // 4,999,982 ns in 12,000,001 ns, rounded up
  REQUIRE(verdict.witness);
}
