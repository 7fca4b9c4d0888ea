#include "analyzer/load/load.hpp"

#include <catch2/catch.hpp>

#include "analyzer/exact/exact.hpp"
#include "analyzer/load/grid.hpp"
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
  const Verdict verdict = analyze_exactly(*skill->problem).verdicts.front();
  CHECK(verdict.state == Verdict::State::fails);
  CHECK(verdict.exact);
  REQUIRE(verdict.bound);
  CHECK(verdict.bound->count() == 416'666'667);  // 5 ms in 12 ms, rounded up
  CHECK(verdict.explanation.text().find("P1") != std::string::npos);
  REQUIRE(verdict.witness);
}

TEST_CASE("the load of a sporadic worker is at most its work in its least separation") {
  const auto skill = test::sound_skill(
      small_skill("REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 42 %", worker,
                  "PROCESSOR P0\nPROCESSOR P1\nDEVICE MC1 EVENT tick SPORADIC 12 ms JITTER 2 ms\nTIME "
                  "work : 1 TO 4 ms\nCOST SET 1 ms\nPLACE SM1 ON P1 PRIORITY 1\n"));
  const Verdict verdict = analyze_exactly(*skill->problem).verdicts.front();
  CHECK(verdict.state == Verdict::State::holds);
  REQUIRE(verdict.bound);
  CHECK(verdict.bound->count() == 416'666'667);  // 5 ms in 12 ms, rounded up
}

TEST_CASE("a load includes the beginning of the skill if a run comes back to it") {
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
  const Verdict verdict = analyze_exactly(*skill->problem).verdicts.front();
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
  const Verdict verdict = analyze_exactly(*skill->problem).verdicts.front();
  CHECK(verdict.state == Verdict::State::never);
  CHECK_FALSE(verdict.bound);
  CHECK(verdict.explanation.text() == "every run ends, and a load is that of the long run");
}

TEST_CASE("a skill that may wait for ever has a load of 0") {
  const auto skill = test::sound_skill(
      small_skill("REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 0 %", R"(
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  WTM( tick from MC1 )
  TXM( Completion Protocol 0 )
END
)",
                  "PROCESSOR P0\nPLACE SM1 ON P0 PRIORITY 1\nDEVICE MC1 EVENT tick SPORADIC 5 ms\n"));
  const Verdict verdict = analyze_exactly(*skill->problem).verdicts.front();
  CHECK(verdict.state == Verdict::State::holds);
  CHECK(verdict.bound == Duration(0));
}

TEST_CASE("a load is exact for any common divisor of the times") {
  const auto skill = test::sound_skill(
      small_skill("REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 40 %", worker,
                  "PROCESSOR P0\nPROCESSOR P1\nDEVICE MC1 EVENT tick EVERY 12000001 ns\nTIME "
                  "work : 1 TO 3999999 ns\nCOST SET 999983 ns\nPLACE SM1 ON P1 PRIORITY 1\n"));
  Options options;
  options.max_states = 5'000;  // far fewer than there are nanoseconds
  const Verdict verdict = analyze_exactly(*skill->problem, options).verdicts.front();
  CHECK(verdict.state == Verdict::State::fails);
  CHECK(verdict.exact);
  REQUIRE(verdict.bound);
  CHECK(verdict.bound->count() == 416'665'132);  // 4,999,982 ns in 12,000,001 ns, rounded up
  REQUIRE(verdict.witness);
}

TEST_CASE("a load is attained by one turn of its run, even if shares of the time proved it") {
  const auto skill = test::sound_skill(
      small_skill("REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 50 %", worker,
                  "PROCESSOR P0\nDEVICE MC1 EVENT tick EVERY 12000001 ns\nTIME "
                  "work : 1 TO 3999999 ns\nCOST SET 999983 ns\nPLACE SM1 ON P0 PRIORITY 1\n"));
  Options options;
  options.max_states = 5'000;
  const Verdict verdict = analyze_exactly(*skill->problem, options).verdicts.front();
  CHECK(verdict.exact);
  CHECK(verdict.explanation.text().find("busy for at most 4.999982 ms in every 12.000001 ms") !=
        std::string::npos);
  CHECK(attained(verdict) == verdict.bound);
}

TEST_CASE("a load with very long times is decided within the default limits") {
  const auto skill =
      test::sound_skill(small_skill("REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 50 %", worker,
                                    "PROCESSOR P0\nDEVICE MC1 EVENT tick EVERY 999999999999999 ns\nTIME "
                                    "work : 1 TO 399999999999997 ns\nPLACE SM1 ON P0 PRIORITY 1\n"));
  const Verdict verdict = analyze_exactly(*skill->problem).verdicts.front();
  CHECK(verdict.state == Verdict::State::holds);
  CHECK(verdict.exact);
  CHECK(verdict.bound == Duration(400'000'000));
}

// Shares count as if the loop gave up for ever and took all ticks.
TEST_CASE("a run above the limit refutes a load of which no run is known to attain the bound") {
  const auto skill = test::sound_skill(small_skill("REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 28 %",
                                                   R"(
Skill Module: SM1
  ACTIVITY work
  ACTIVITY other
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( tick from MC1 ) WITHIN 10000001 ns
      work
    ELSE
      other
    END WTM
  UNTIL( forever )
END
)",
                                                   "PROCESSOR P0\nDEVICE MC1 EVENT tick EVERY 28000003 ns\n"
                                                   "TIME work : 4999999 ns\nTIME other : 2000003 ns\n"
                                                   "PLACE SM1 ON P0 PRIORITY 1\n"));
  Options options;
  options.max_states = 5'000;
  const Verdict verdict = analyze_exactly(*skill->problem, options).verdicts.front();
  INFO(verdict.explanation.text());
  CHECK(verdict.state == Verdict::State::fails);
  CHECK_FALSE(verdict.exact);
  REQUIRE(verdict.bound);
  REQUIRE(attained(verdict));
  CHECK(*attained(verdict) > Duration(280'000'000));
  CHECK(*attained(verdict) < *verdict.bound);
  CHECK(verdict.witness);
  CHECK(verdict.addends.empty());
}

namespace {

/// The load of P0, where a loop of SM1 has `round` in it, by shares of the time: work may end at any
/// nanosecond, which makes too many points for a grid.
Verdict by_shares(const std::string& round, const std::string& device) {
  const auto skill = test::sound_skill(
      small_skill("REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 100 %",
                  "\nSkill Module: SM1\n  ACTIVITY work\nBEGIN\n  WTM( Coordinator )\n  REPEAT\n" + round +
                      "\n  UNTIL( forever )\nEND\n",
                  "PROCESSOR P0\nPLACE SM1 ON P0 PRIORITY 1\nTIME work : 1 TO 1000003 ns\n" + device));
  Options options;
  options.max_states = 5'000;
  return analyze_exactly(*skill->problem, options).verdicts.front();
}

}  // namespace

TEST_CASE("a limited wait counts in the load for the part of its limit that passed") {
  const Verdict verdict =
      by_shares("WTM( tick from MC1 ) WITHIN 10000001 ns\n  work\nELSE\n  Do Nothing\nEND WTM",
                "DEVICE MC1 EVENT tick EVERY 2000003 ns\n");
  INFO(verdict.explanation.text());
  CHECK(verdict.exact);
  CHECK(verdict.bound == Duration(500'000'750));  // 1,000,003 in 2,000,003, rounded up
}

TEST_CASE("an answer counts in the load with the least time that it may take") {
  const Verdict verdict = by_shares("TXM( request value to LS1 )\nWTM( value from LS1 )\nwork",
                                    "DEVICE LS1 ON REQUEST 999997 TO 9999991 ns\n");
  INFO(verdict.explanation.text());
  CHECK(verdict.exact);
  CHECK(verdict.bound == Duration(500'001'500));  // 1,000,003 in 2,000,000
}

// It works without a pause while LS1 takes its time, and rests while LS1 takes it again. Round a loop of the
// work everything comes back but what LS1 has done.
TEST_CASE("a stretch of a run is no turn if an action that goes on throughout it does not come back") {
  const auto skill = test::sound_skill(R"(MESSAGE value : SIGNAL
SKILL s
  LOGICAL SENSOR LS1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT load : LOAD OF P0 AT MOST 60 %
END SKILL
Logical Sensor: LS1
  ACTIVITY think
BEGIN
  REPEAT
    think
    TXM( value to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( value from LS1 ) WITHIN 0 ms
      WTM( value from LS1 )
    ELSE
      work
    END WTM
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR P1
  PLACE SM1 ON P0 PRIORITY 1
  PLACE LS1 ON P1 PRIORITY 1
  TIME think OF LS1 : 999999937 TO 1009999937 ns
  TIME work OF SM1 : 10000019 ns
END ENVIRONMENT
)");
  Options options;
  options.max_states = 2'000;
  const Verdict verdict = analyze_exactly(*skill->problem, options).verdicts.front();
  INFO(verdict.explanation.text());
  CHECK(verdict.state != Verdict::State::fails);
  REQUIRE(attained(verdict));
  CHECK(*attained(verdict) < Duration(600'000'000));
}

TEST_CASE("a grid can be stopped while it looks for its entry points") {
  const auto skill =
      test::sound_skill(small_skill("REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 40 %", worker,
                                    "PROCESSOR P0\nPROCESSOR P1\nDEVICE MC1 EVENT tick EVERY 7919 us JITTER "
                                    "7907 us\nTIME work : 1 us\nPLACE SM1 ON P1 PRIORITY 1\n"));
  const Watch nothing;
  const Machine machine(*skill->problem, nothing);
  ZoneGraph graph(machine, 0, true);
  REQUIRE(graph.explore({}));
  std::size_t grids = 0;
  for (const Recurrence& recurrence : recurrences(graph)) {
    const Slice slice = slice_of(machine, graph, recurrence, ProcessorId{1});
    int asked = 0;
    Limits limits;
    limits.stop = [&asked] { return ++asked > 1; };
    Grid grid(machine, slice);
    if (!grid.start(graph, recurrence, limits)) ++grids;
    CHECK(asked <= 2);
    CHECK(grid.nodes().size() <= 10'000);
  }
  CHECK(grids > 0);
}
