// The worked cases of the timing design, by number. All costs are zero unless given.
#include <set>

#include <catch2/catch.hpp>

#include "analyzer/exact/exact.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/reference/range_finder.hpp"
#include "tests/support/confirm.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::sound_skill;
using namespace std::chrono_literals;

namespace {

const Verdict& verdict(const Analysis& analysis, const std::string& requirement) {
  for (const Verdict& each : analysis.verdicts) {
    if (each.requirement == requirement) return each;
  }
  throw std::runtime_error("no requirement " + requirement);
}

/// The skill of figure 3.6 with its second block as given. What is asked for elsewhere are devices.
std::string figure_3_6(const std::string& block) {
  return R"(
MESSAGE Zforce : REAL N
MESSAGE motion : dz : REAL mm
CONDITION pc-force FROM Zforce "touching"
CONDITION pc-reach             "too far"

SKILL touch
  SENSOR DRIVER      NONE
  LOGICAL SENSOR     LS1
  MACHINE CONTROLLER MC1
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "touching"
  COMPLETION 1 ERROR  "any other error"
  REQUIREMENT answer   : RESPONSE FROM motion request OF MC1 TO TXM( motion to MC1 ) AT MOST 1 ms
  REQUIREMENT at-read  : AGE OF pc-force AT RPC( pc-force ) IN SM1 AT MOST 10 ms
  REQUIREMENT at-use   : AGE OF pc-force AT TXM( motion to MC1 ) IN SM1 AT MOST 10 ms
END SKILL

Logical Sensor: LS1
Machine Controller: MC1

Skill Module: SM1
BEGIN
  WTM( Coordinator )
  TXM( request Zforce from LS1 )
  WTM( Zforce from LS1 )
  SPC( pc-force )
  CONCURRENT
  BEGIN
    REPEAT
      TXM( request Zforce from LS1 )
      WTM( Zforce from LS1 )
      SPC( pc-force )
    UNTIL( forever )
  END
  BEGIN
    REPEAT
)" + block +
         R"(
    UNTIL( pc-force OR pc-reach )
  END
  END CONCURRENT
  TXM( Completion Protocol 0 )
END

ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR P1
  DEVICE MC1 EVENT motion request EVERY 28 ms
  DEVICE LS1 ON REQUEST 6 ms
  PLACE SM1   ON P0 PRIORITY 1
  PLACE SM1.1 ON P1 PRIORITY 1
END ENVIRONMENT
)";
}

const char* const as_printed = R"(
      RPC( pc-force )
      CASE
        ( pc-force = TRUE ): Do Nothing
        ( pc-force = FALSE ):
          WTM( motion request from MC1 )
          TXM( motion to machine controller MC1 )
          SPC( pc-reach )
      END CASE
)";

const char* const corrected = R"(
      WTM( motion request from MC1 )
      RPC( pc-force )
      CASE
        ( pc-force = TRUE ):
          TXM( motion to machine controller MC1 )
        ( pc-force = FALSE ):
          TXM( motion to machine controller MC1 )
          SPC( pc-reach )
      END CASE
)";

void expect_attained(const Analysis& analysis, const std::string& requirement, Duration bound) {
  const Verdict& found = verdict(analysis, requirement);
  INFO(requirement << ": " << found.explanation.text());
  REQUIRE(found.bound);
  CHECK(*found.bound == bound);
  CHECK(found.exact);
  REQUIRE(found.witness);
  CHECK(found.witness->measured.value == bound.count());
  Nanoseconds sum = 0;
  for (const Reason& reason : found.reasons) sum += reason.to - reason.from;
  CHECK(sum == bound.count());
}

std::string one_sequence(const std::string& sensor) {
  return R"(
MESSAGE Zforce : REAL N
MESSAGE motion : dz : REAL mm
CONDITION pc-force FROM Zforce "touching"
SKILL touch
  SENSOR DRIVER      NONE
  LOGICAL SENSOR     LS1
  MACHINE CONTROLLER MC1
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "touching"
  COMPLETION 1 ERROR  "any other error"
  REQUIREMENT answer : RESPONSE FROM motion request OF MC1 TO TXM( motion to MC1 ) AT MOST 10 ms
END SKILL
Logical Sensor: LS1
Machine Controller: MC1
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  REPEAT
    WTM( motion request from MC1 )
    TXM( request Zforce from LS1 )
    WTM( Zforce from LS1 )
    SPC( pc-force )
    TXM( motion to MC1 )
  UNTIL( pc-force )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P0
  DEVICE MC1 EVENT motion request EVERY 28 ms
  DEVICE LS1 )" +
         sensor + R"(
  PLACE SM1 ON P0 PRIORITY 1
END ENVIRONMENT
)";
}

/// It is not stopped while the simulation lasts.
std::string undisturbed_range_finder(const std::string& body) {
  return pal::test::range_finder(body, "10 TO 15 ms", "", "EVERY 100 s PHASE 99 s");
}

const char* const three_drivers = R"(
MESSAGE tick-1 : SIGNAL
MESSAGE tick-2 : SIGNAL
MESSAGE tick-3 : SIGNAL
DEVICE clock-1 "7 ms"
DEVICE clock-2 "12 ms"
DEVICE clock-3 "20 ms"
SKILL drivers
  SENSOR DRIVER      NONE
  LOGICAL SENSOR     NONE
  MACHINE CONTROLLER MC1, MC2, MC3, MC4
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "done"
  COMPLETION 1 ERROR  "any other error"
  REQUIREMENT first  : RESPONSE FROM tick-1 OF clock-1 TO work-1 IN MC1 AT MOST 3 ms
  REQUIREMENT second : RESPONSE FROM tick-2 OF clock-2 TO work-2 IN MC2 AT MOST 6 ms
  REQUIREMENT third  : RESPONSE FROM tick-3 OF clock-3 TO work-3 IN MC3 AT MOST 19 ms
END SKILL
Machine Controller: MC1
  ACTIVITY work-1
BEGIN
  REPEAT
    WTM( tick-1 from clock-1 )
    work-1
  UNTIL( forever )
END
Machine Controller: MC2
  ACTIVITY work-2
BEGIN
  REPEAT
    WTM( tick-2 from clock-2 )
    work-2
  UNTIL( forever )
END
Machine Controller: MC3
  ACTIVITY work-3
BEGIN
  REPEAT
    WTM( tick-3 from clock-3 )
    work-3
  UNTIL( forever )
END
MESSAGE stop : SIGNAL
Machine Controller: MC4
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  WTM( stop from MC4 )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR P1
  DEVICE clock-1 EVENT tick-1 EVERY 7 ms
  DEVICE clock-2 EVENT tick-2 EVERY 12 ms
  DEVICE clock-3 EVENT tick-3 EVERY 20 ms
  DEVICE MC4 EVENT stop SPORADIC 1 ms
  TIME work-1 : 3 ms
  TIME work-2 : 3 ms
  TIME work-3 : 5 ms
  PLACE MC1 ON P0 PRIORITY 3
  PLACE MC2 ON P0 PRIORITY 2
  PLACE MC3 ON P0 PRIORITY 1
  PLACE SM1 ON P1 PRIORITY 1
END ENVIRONMENT
)";

}  // namespace

TEST_CASE("case 1: figure 3.6 as printed decides on a force that is up to 34 ms old") {
  const auto skill = sound_skill(figure_3_6(as_printed));
  const Analysis analysis = analyze_exactly(*skill->problem);
  expect_attained(analysis, "at-read", 6ms);
  expect_attained(analysis, "at-use", 34ms);
  CHECK(verdict(analysis, "at-use").state == Verdict::State::fails);
  expect_attained(analysis, "answer", 0ms);
}

TEST_CASE("case 1: waiting first, it decides on one that is up to 6 ms old") {
  const auto skill = sound_skill(figure_3_6(corrected));
  const Analysis analysis = analyze_exactly(*skill->problem);
  expect_attained(analysis, "at-read", 6ms);
  expect_attained(analysis, "at-use", 6ms);
  CHECK(verdict(analysis, "at-use").state == Verdict::State::holds);
  expect_attained(analysis, "answer", 0ms);
}

TEST_CASE("case 2: in one sequence with free-running frames the answer takes up to 12 ms") {
  const auto skill = sound_skill(one_sequence("FRAMES EVERY 6 ms COLLECTING 6 ms"));
  const Analysis analysis = analyze_exactly(*skill->problem);
  expect_attained(analysis, "answer", 12ms);
  CHECK(verdict(analysis, "answer").state == Verdict::State::fails);
}

TEST_CASE("case 2: with the sensor on request it takes 6 ms") {
  const auto skill = sound_skill(one_sequence("ON REQUEST 6 ms"));
  expect_attained(analyze_exactly(*skill->problem), "answer", 6ms);
}

TEST_CASE("case 3: asking after interpreting loses every second frame, asking before loses none") {
  const auto gaps = [](const std::string& body) {
    const auto skill = sound_skill(undisturbed_range_finder(body));
    const Watch nothing;
    const Machine machine(*skill->problem, nothing);
    SimulationOptions options;
    options.times = SimulationOptions::Times::random;
    options.until = 10'000'000'000;
    const Simulation run = simulate(machine, options);
    std::vector<Nanoseconds> times;
    for (const trace::Event& event : run.trace.events) {
      const bool profile = event.kind == trace::Kind::put &&
                           run.trace.channels[static_cast<std::size_t>(event.subject)].message == "profile";
      if (profile) times.push_back(event.time_ns);
    }
    std::set<Nanoseconds> found;
    for (std::size_t i = 2; i < times.size(); ++i) found.insert(times[i] - times[i - 1]);
    return found;
  };
  CHECK(gaps(R"(
  REPEAT
    TXM( request profile from finder )
    WTM( profile from finder )
    interpret
  UNTIL( forever ))") == std::set<Nanoseconds>{156'000'000});
  CHECK(gaps(R"(
  TXM( request profile from finder )
  REPEAT
    WTM( profile from finder )
    TXM( request profile from finder )
    interpret
  UNTIL( forever ))") == std::set<Nanoseconds>{78'000'000});
}

TEST_CASE("the referee confirms the runs behind the worked cases") {
  for (const std::string& text :
       {figure_3_6(as_printed), figure_3_6(corrected), one_sequence("FRAMES EVERY 6 ms COLLECTING 6 ms"),
        one_sequence("ON REQUEST 6 ms"), std::string(three_drivers)}) {
    const auto skill = sound_skill(text);
    CHECK(test::unconfirmed(*skill->problem, analyze_exactly(*skill->problem)) == "");
  }
}

TEST_CASE("case 4: three periodic drivers on one processor answer within 3, 6 and 20 ms") {
  const auto skill = sound_skill(three_drivers);
  const Analysis analysis = analyze_exactly(*skill->problem);
  expect_attained(analysis, "first", 3ms);
  expect_attained(analysis, "second", 6ms);
  expect_attained(analysis, "third", 20ms);
  CHECK(verdict(analysis, "third").state == Verdict::State::fails);
}
