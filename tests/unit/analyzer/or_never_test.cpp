// Devices that may not answer.
#include <catch2/catch.hpp>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/exact/exact.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

/// Weighs once: the answer comes within 100 ms, and is waited for in this way.
std::string weighing(const std::string& wait, const std::string& never) {
  return R"(
MESSAGE weight : load : REAL kg
SKILL weigh
  MACHINE CONTROLLER Scale
  SKILL METHOD  SM1
  REQUIREMENT light : DURATION TO COMPLETION 0 AT MOST 1 s
  REQUIREMENT late  : DURATION TO COMPLETION 1 AT MOST 1 s
  REQUIREMENT lost  : LOSS OF Scale NONE
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
END SKILL
Machine Controller: Scale
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  TXM( request weight from Scale )
  WTM( weight from Scale ))" +
         wait + R"(
END
ENVIRONMENT bench
  PROCESSOR P0
  DEVICE Scale ON REQUEST 80 TO 100 ms)" +
         never + R"(
  PLACE SM1 ON P0 PRIORITY 1
END ENVIRONMENT
)";
}

const char* const limited = R"( WITHIN 150 ms
    TXM( Completion Protocol 0 )
  ELSE
    TXM( Completion Protocol 1 )
  END WTM)";

const char* const endless = "\n  TXM( Completion Protocol 0 )";

}  // namespace

TEST_CASE("a wait gives up only if its device may not answer") {
  const auto sure = test::sound_skill(weighing(limited, ""));
  const Analysis answered = analyze_exactly(*sure->problem);
  CHECK(answered.verdicts[0].bound == Duration(100 * 1'000'000));
  CHECK(answered.verdicts[1].state == VerdictState::never);
  const auto unsure = test::sound_skill(weighing(limited, " OR NEVER"));
  const Analysis unanswered = analyze_exactly(*unsure->problem);
  CHECK(unanswered.verdicts[0].bound == Duration(100 * 1'000'000));
  CHECK(unanswered.verdicts[1].state == VerdictState::holds);
  CHECK(unanswered.verdicts[1].bound == Duration(150 * 1'000'000));
  CHECK(unanswered.verdicts[1].exact);
  CHECK(unanswered.verdicts[2].state == VerdictState::holds);  // no answer is no loss
  CHECK(unanswered.verdicts[2].bound == Duration(0));
}

TEST_CASE("a wait without a limit for an answer that may never come is named") {
  const auto skill = test::sound_skill(weighing(endless, " OR NEVER"));
  CHECK(test::messages(skill->diagnostics).find("PAL0733 Scale may never answer") != std::string::npos);
  CHECK(test::messages(test::sound_skill(weighing(limited, " OR NEVER"))->diagnostics).find("PAL0733") ==
        std::string::npos);
  CHECK(test::messages(test::sound_skill(weighing(endless, ""))->diagnostics).find("PAL0733") ==
        std::string::npos);
}

TEST_CASE("the compositional analysis names the device that keeps it from a bound") {
  const auto skill = test::sound_skill(weighing(limited, " OR NEVER"));
  const Verdict verdict = compositional::analyze(*skill->problem, {}).verdicts.front();
  CHECK_FALSE(verdict.bound);
  CHECK(verdict.explanation.text().find("Scale may not answer a request (OR NEVER)") != std::string::npos);
}

TEST_CASE("the simulation makes runs in which the device answers and runs in which it does not") {
  const auto skill = test::sound_skill(weighing(limited, " OR NEVER"));
  const Watch nothing;
  const Machine machine(*skill->problem, nothing);
  bool early = false;
  bool late = false;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SimulationOptions how;
    how.seed = seed;
    const Simulation run = simulate(machine, how);
    REQUIRE(run.ended);
    early = early || run.end == 100 * 1'000'000;
    late = late || run.end == 150 * 1'000'000;
  }
  CHECK(early);
  CHECK(late);
}
