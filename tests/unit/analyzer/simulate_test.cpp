// A run in which time stands still ends; sporadic events wait for as long as what there is takes.
#include <catch2/catch.hpp>

#include "analyzer/analysis.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/skill.hpp"
#include "tests/unit/analyzer/small_skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

/// SM1 and LS1 talk with one another, for ever; what that takes is the costs of a send and of a set.
std::unique_ptr<test::Skill> talk(const std::string& costs) {
  return test::skill_from_text(R"(
MESSAGE value : SIGNAL
CONDITION pc-high
SKILL talk
  LOGICAL SENSOR LS1
  SKILL METHOD   SM1
  COMPLETION 1 ERROR
  REQUIREMENT steady : INTERVAL OF SPC( pc-high ) AT MOST 1 ms
END SKILL
Logical Sensor: LS1
BEGIN
  REPEAT
    WTM( request value from SM1 )
    TXM( value to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  SPC( pc-high )
  REPEAT
    TXM( request value from LS1 )
    WTM( value from LS1 )
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P0
  PLACE SM1 ON P0 PRIORITY 1
  PLACE LS1 ON P0 PRIORITY 2
)" + costs + "\nEND ENVIRONMENT\n");
}

Simulation run(const Problem& problem, SimulationOptions::Times times, std::size_t most = 1'000'000) {
  const Watch nothing;
  const Machine machine(problem, nothing);
  SimulationOptions how;
  how.times = times;
  how.max_events = most;
  how.until = 20'000'000;
  how.record = false;
  return simulate(machine, how);
}

}  // namespace

TEST_CASE("20,000 events at one instant end a run") {
  const auto skill = talk("COST SET 2 ms");
  REQUIRE(skill->problem);
  const Simulation made = run(*skill->problem, SimulationOptions::Times::random);
  CHECK_FALSE(made.ended);
  CHECK_FALSE(made.still);
  CHECK(made.end == 2'000'000);
  REQUIRE(made.script.size() > 20'000);
  CHECK(made.script.size() < 20'010);
  CHECK(made.script[made.script.size() - 20'000].at == made.end);
}

TEST_CASE("many events end a run if no time passes between them, and do not if time passes") {
  const auto skill = talk("COST SEND 0 TO 1 us");
  REQUIRE(skill->problem);
  CHECK(run(*skill->problem, SimulationOptions::Times::best).script.size() < 20'010);
  const Simulation worst = run(*skill->problem, SimulationOptions::Times::worst);
  CHECK(worst.end == 20'000'000);
  CHECK(worst.script.size() > 30'000);
}

TEST_CASE("runs of a slow skill that a sporadic event ends reach its slow events") {
  const auto skill = test::skill_from_text(R"(
MESSAGE tick : SIGNAL
MESSAGE stop : SIGNAL
DEVICE clock
DEVICE button
SKILL slow
  MACHINE CONTROLLER MC1, MC2
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT r : RESPONSE FROM tick OF clock TO work AT MOST 1 s
END SKILL
Machine Controller: MC1
  ACTIVITY work
BEGIN
  REPEAT
    WTM( tick from clock )
    work
  UNTIL( forever )
END
Machine Controller: MC2
BEGIN
  REPEAT
    WTM( stop from button )
    TXM( stop to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  WTM( stop from MC2 )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P0
  PLACE SM1 ON P0 PRIORITY 1
  PLACE MC1 ON P0 PRIORITY 2
  PLACE MC2 ON P0 PRIORITY 3
  TIME work : 2 s
  DEVICE clock  EVENT tick EVERY 900 s PHASE 60 s
  DEVICE button EVENT stop SPORADIC 1 s
END ENVIRONMENT
)");
  REQUIRE(skill->problem);
  const Verdict verdict = analyze(*skill->problem, AnalysisChoice::compositional).verdicts.front();
  INFO(verdict.explanation.text());
  CHECK(verdict.state == Verdict::State::fails);
  CHECK(verdict.bound == Duration(2'000'000'000));
}
