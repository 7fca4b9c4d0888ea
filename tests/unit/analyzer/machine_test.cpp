// The execution model, rule by rule, seen in runs and bounds.
#include "analyzer/machine/machine.hpp"

#include <catch2/catch.hpp>

#include "analyzer/exact/exact.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/skill.hpp"
#include "tests/unit/analyzer/small_skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using test::small_skill;
using test::worker;

namespace {

Simulation run(const Problem& problem, std::uint64_t seed = 1) {
  const Watch nothing;
  const Machine machine(problem, nothing);
  SimulationOptions options;
  options.seed = seed;
  options.until = 200'000'000;
  return simulate(machine, options);
}

int count(const trace::Trace& trace, trace::Kind kind, const std::string& message) {
  int found = 0;
  for (const trace::Event& event : trace.events) {
    if (event.kind == kind && event.subject >= 0 &&
        trace.channels[static_cast<std::size_t>(event.subject)].message == message)
      ++found;
  }
  return found;
}

Verdict only(const Problem& problem) {
  return analyze_exactly(problem).verdicts.front();
}

}  // namespace

TEST_CASE("a request that was given up is not answered later") {
  const auto skill = test::sound_skill(small_skill(
      "", R"(
Skill Module: SM1
  ACTIVITY rest
BEGIN
  WTM( Coordinator )
  REPEAT
    TXM( request value from LS1 )
    WTM( value from LS1 ) WITHIN 2 ms
      SPC( pc-high )
    ELSE
      rest
    END WTM
  UNTIL( pc-high )
  TXM( Completion Protocol 0 )
END
)",
      "PROCESSOR P0\nDEVICE LS1 ON REQUEST 5 ms\nTIME rest : 10 ms\nPLACE SM1 ON P0 PRIORITY 1\n"));
  const Simulation made = run(*skill->problem);
  CHECK(count(made.trace, trace::Kind::drop, "value") > 10);
  CHECK(count(made.trace, trace::Kind::put, "value") == 0);
  CHECK_FALSE(made.ended);
}

TEST_CASE(
    "giving up withdraws the thread's own request, not that of a sender whose slot becomes free by it") {
  const auto waits = [](const std::string& limit) {
    return "  BEGIN\n    TXM( request value from LS1 )\n    WTM( value from LS1 ) WITHIN " + limit +
           " ms\n      rest\n    ELSE\n      rest\n    END WTM\n  END\n";
  };
  // The first request is being served, the second in the slot, and the third sender blocked, when the first
  // block gives up at 2 ms.
  const auto skill = test::any_skill(small_skill(
      "",
      "Skill Module: SM1\n  ACTIVITY rest\nBEGIN\n  WTM( Coordinator )\n  CONCURRENT\n" + waits("2") +
          waits("50") + waits("50") + "  END CONCURRENT\n  TXM( Completion Protocol 0 )\nEND\n",
      "PROCESSOR P0\nDEVICE LS1 ON REQUEST 10 ms\nTIME rest : 1 ms\nPLACE SM1 ON P0 PRIORITY 1\n"));
  const Simulation made = run(*skill->problem);
  CHECK(count(made.trace, trace::Kind::drop, "request value") == 1);
  CHECK(count(made.trace, trace::Kind::take, "request value") == 2);
  CHECK(count(made.trace, trace::Kind::put, "value") == 1);
  CHECK(made.ended);
}

TEST_CASE("a block that cannot end is cancelled, and what it asked for is not delivered") {
  const auto skill = test::sound_skill(
      small_skill("", R"(
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  CONCURRENT
  BEGIN
    REPEAT
      TXM( request value from LS1 )
      WTM( value from LS1 )
      SPC( pc-high )
    UNTIL( forever )
  END
  BEGIN
    WTM( tick from MC1 )
  END
  END CONCURRENT
  WTM( stop from MC2 )
  TXM( Completion Protocol 0 )
END
)",
                  "PROCESSOR P0\nPROCESSOR P1\nDEVICE LS1 ON REQUEST 5 ms\nDEVICE MC1 EVENT tick EVERY 12 ms "
                  "PHASE 11 ms\nDEVICE MC2 EVENT stop EVERY 50 ms PHASE 40 ms\nPLACE SM1 ON P0 PRIORITY "
                  "1\nPLACE SM1.1 ON P1 PRIORITY 1\n"));
  const Simulation made = run(*skill->problem);
  CHECK(made.ended);
  CHECK(count(made.trace, trace::Kind::put, "value") == 2);   // at 5 and 10 ms
  CHECK(count(made.trace, trace::Kind::drop, "value") == 1);  // the one due at 15 ms
  CHECK(made.trace.events.back().time_ns == 51'000'000);
}

TEST_CASE("an event that finds its slot full fails its response") {
  const auto skill = test::sound_skill(small_skill(
      "REQUIREMENT answer : RESPONSE FROM tick OF MC1 TO work IN SM1 AT MOST 100 ms", worker,
      "PROCESSOR P0\nDEVICE MC1 EVENT tick EVERY 10 ms\nTIME work : 11 ms\nPLACE SM1 ON P0 PRIORITY 1\n"));
  const Verdict verdict = only(*skill->problem);
  CHECK(verdict.state == Verdict::State::fails);
  CHECK_FALSE(verdict.bound);
  REQUIRE(verdict.witness);
  CHECK(verdict.witness->failed);
}

TEST_CASE("jitter brings events nearer to one another") {
  const auto skill = test::sound_skill(
      small_skill("REQUIREMENT answer : RESPONSE FROM tick OF MC1 TO work IN SM1 AT MOST 9 ms", worker,
                  "PROCESSOR P0\nDEVICE MC1 EVENT tick EVERY 10 ms JITTER 3 ms\nTIME work : 8 ms\nPLACE SM1 "
                  "ON P0 PRIORITY 1\n"));
  const Verdict verdict = only(*skill->problem);
  // 3 ms late, then on time: 7 ms apart, one of 8 ms still to be finished.
  REQUIRE(verdict.bound);
  CHECK(verdict.bound->count() == 9'000'000);
  CHECK(verdict.exact);
}

TEST_CASE("an age grows without bound if nothing sets the condition again") {
  const auto skill = test::sound_skill(small_skill(
      "REQUIREMENT age : AGE OF pc-high AT work IN SM1 AT MOST 50 ms", R"(
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  SPC( pc-high )
  REPEAT
    WTM( tick from MC1 )
    RPC( pc-high )
    work
  UNTIL( forever )
END
)",
      "PROCESSOR P0\nDEVICE MC1 EVENT tick EVERY 10 ms\nTIME work : 1 ms\nPLACE SM1 ON P0 PRIORITY 1\n"));
  const Verdict verdict = only(*skill->problem);
  CHECK(verdict.state == Verdict::State::fails);
  CHECK_FALSE(verdict.bound);
  REQUIRE(verdict.witness);
  CHECK(verdict.witness->measured.value > 50'000'000);
}

TEST_CASE("an exploration that meets its limit decides nothing") {
  const auto skill = test::sound_skill(small_skill(
      "REQUIREMENT answer : RESPONSE FROM tick OF MC1 TO work IN SM1 AT MOST 9 ms", worker,
      "PROCESSOR P0\nDEVICE MC1 EVENT tick EVERY 10 ms\nTIME work : 8 ms\nPLACE SM1 ON P0 PRIORITY 1\n"));
  Options options;
  options.max_states = 1;
  CHECK(analyze_exactly(*skill->problem, options).verdicts.front().state == Verdict::State::undecided);
  options.max_states = 1000;
  CHECK(analyze_exactly(*skill->problem, options).verdicts.front().state == Verdict::State::holds);
}

TEST_CASE("an event that is never answered fails without an overrun, even if nothing happens any more") {
  const auto skill = test::sound_skill(
      small_skill("  REQUIREMENT answer : RESPONSE FROM tick OF MC1 TO SPC( pc-high ) AT MOST 50 ms", R"(
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  WTM( tick from MC1 )
  WTM( stop from MC2 )
  SPC( pc-high )
  TXM( Completion Protocol 0 )
END
)",
                  "PROCESSOR P0\nDEVICE MC1 EVENT tick SPORADIC 10 s\nDEVICE MC2 EVENT stop SPORADIC 1 s\n"
                  "TIME work : 1 ms\nPLACE SM1 ON P0 PRIORITY 1\n"));
  const Verdict found = only(*skill->problem);
  INFO(found.explanation.text());
  CHECK(found.state == Verdict::State::fails);
  REQUIRE(found.witness);
  CHECK(found.witness->measured.value > 50'000'000);
}

TEST_CASE("a requirement that no run can measure is reported") {
  const auto skill = test::sound_skill(small_skill(
      R"(  REQUIREMENT age   : AGE OF pc-high AT work IN SM1 AT MOST 50 ms
  REQUIREMENT twice : INTERVAL OF SPC( pc-high ) IN SM1 AT MOST 50 ms
  REQUIREMENT error : DURATION TO COMPLETION 1 AT MOST 50 ms
)",
      R"(
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  SPC( pc-high = TRUE )
  CASE
    ( pc-high = TRUE ):
      Do Nothing
    ( pc-high = FALSE ):
      work
  END CASE
  TXM( Completion Protocol 0 )
END
)",
      "PROCESSOR P0\nTIME work : 1 ms\nPLACE SM1 ON P0 PRIORITY 1\n"));
  const Analysis analysis = analyze_exactly(*skill->problem);
  for (const Verdict& each : analysis.verdicts) {
    INFO(each.requirement << ": " << each.explanation.text());
    CHECK(each.state == Verdict::State::never);
    CHECK_FALSE(each.witness);
  }
  CHECK(analysis.verdicts[0].explanation.text() == "no run ever gets there");
  CHECK(analysis.verdicts[1].explanation.text() == "no run gets there twice");
}
