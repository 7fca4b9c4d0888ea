// The referee and the machine, written apart, must agree on what a run is.
#include <catch2/catch.hpp>
#include <iostream>
#include <sstream>

#include "analyzer/exact.hpp"
#include "analyzer/replay/check_run.hpp"
#include "analyzer/replay/witness_file.hpp"
#include "analyzer/simulate.hpp"
#include "tests/support/confirm.hpp"
#include "tests/support/mutant.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/skill.hpp"
#include "tests/support/timed_skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::refusal;
using pal::test::setting;
using pal::test::shows;

namespace {

constexpr Nanoseconds millisecond = 1'000'000;

/// A skill by chance; every third one a timed one that is changed in a few places.
std::string program(std::uint64_t seed) {
  if (seed % 3 != 0) return test::RandomSkill(seed, 9).text();
  const auto sound = [](const std::string& text) { return test::skill_from_text(text)->problem.has_value(); };
  return test::Mutant(seed, test::TimedSkill(seed).text(), sound).text(1 + static_cast<int>(seed / 3 % 5));
}

/// The last events of a run, to read.
std::string tail(const trace::Trace& run) {
  std::ostringstream out;
  for (std::size_t e = run.events.size() < 60 ? 0 : run.events.size() - 60; e < run.events.size(); ++e) {
    const trace::Event& event = run.events[e];
    out << event.time_ns << " " << trace::name(event.kind) << " "
        << (event.actor < 0 ? "" : run.actors[static_cast<std::size_t>(event.actor)].name) << " "
        << (event.statement < 0 ? "" : run.statements[static_cast<std::size_t>(event.statement)].text) << " "
        << event.subject << " " << event.value << "\n";
  }
  return out.str();
}

/// The events `e` and the next in the other order, at the times of before.
trace::Trace swapped(const trace::Trace& run, std::size_t e) {
  trace::Trace made = run;
  std::swap(made.events[e], made.events[e + 1]);
  std::swap(made.events[e].time_ns, made.events[e + 1].time_ns);
  return made;
}

struct Changes {
  std::size_t made = 0;
  std::size_t refused = 0;

  void count(bool refusal) {
    ++made;
    refused += refusal ? 1 : 0;
  }
};

trace::Trace up_to(const trace::Trace& run, Nanoseconds time) {
  trace::Trace made = run;
  std::erase_if(made.events, [time](const trace::Event& event) { return event.time_ns > time; });
  return made;
}

}  // namespace

TEST_CASE("every simulated run keeps the rules, and shows the same values") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 60);
  std::size_t events = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    const std::string text = program(seed);
    const auto skill = test::skill_from_text(text);
    if (!skill->problem) continue;
    for (const Requirement& requirement : skill->problem->requirements) {
      if (requirement.measure == Requirement::Measure::load) continue;
      const Watch watch = watch_of(*skill->problem, requirement);
      const Machine machine(*skill->problem, watch);
      for (std::uint64_t run = 0; run < 4; ++run) {
        SimulationOptions options;
        options.times = run < 2 ? SimulationOptions::Times::random : SimulationOptions::Times::extremes;
        options.seed = seed * 100 + run;
        options.until = 300 * millisecond;
        options.max_events = 1'000;
        const Simulation made = simulate(machine, options);
        const rules::Ruling ruling = rules::check_run(*skill->problem, &requirement, made.trace);
        INFO("seed " << seed << " run " << run << " " << requirement.name << "\n"
                     << text
                     << tail(up_to(made.trace,
                                   ruling.broken.empty() ? 0 : std::atoll(ruling.broken.c_str() + 3))));
        REQUIRE(ruling.broken == "");
        REQUIRE(ruling.failed == made.failed);
        for (const Measurement& measured : made.measured) REQUIRE(shows(ruling, measured));
        events += made.trace.events.size();
      }
    }
  }
  std::cout << events << " events\n";
  CHECK(events > 0);
}

TEST_CASE("no run shows the referee more than was proved") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 20);
  std::size_t compared = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    const std::string text = program(seed);
    const auto skill = test::skill_from_text(text);
    if (!skill->problem) continue;
    const Problem& problem = *skill->problem;
    Options options;
    options.max_states = 2'500;
    const Analysis analysis = analyze(problem, options);
    const Watch nothing;
    const Machine machine(problem, nothing);
    for (std::uint64_t run = 0; run < 8; ++run) {
      SimulationOptions how;
      how.times = run % 2 == 0 ? SimulationOptions::Times::random : SimulationOptions::Times::extremes;
      how.seed = seed * 100 + run;
      how.until = 300 * millisecond;
      how.max_events = 1'000;
      const Simulation made = simulate(machine, how);
      for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
        const Requirement& requirement = problem.requirements[r];
        const Verdict& verdict = analysis.verdicts[r];
        if (requirement.measure == Requirement::Measure::load) continue;
        const rules::Ruling ruling = rules::check_run(problem, &requirement, made.trace);
        INFO("seed " << seed << " run " << run << " " << requirement.name << "\n"
                     << text << tail(made.trace));
        if (verdict.state == Verdict::State::holds) REQUIRE_FALSE(ruling.failed);
        if (verdict.state == Verdict::State::never) REQUIRE(ruling.measured.empty());
        for (const auto& measured : ruling.measured) {
          if (!verdict.bound) break;
          const Duration value(measured.value);
          REQUIRE((requirement.at_least ? value >= *verdict.bound : value <= *verdict.bound));
          ++compared;
        }
      }
    }
  }
  std::cout << compared << " values compared with bounds\n";
  CHECK(compared > 0);
}

TEST_CASE("the referee confirms every witness, and no changed one") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 10);
  std::size_t witnesses = 0;
  Changes moved;
  Changes left_out;
  Changes reordered;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    const std::string text = program(seed);
    const auto skill = test::skill_from_text(text);
    if (!skill->problem) continue;
    const Problem& problem = *skill->problem;
    Options options;
    options.max_states = 2'500;
    const Analysis analysis = analyze(problem, options);
    for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
      const Requirement& requirement = problem.requirements[r];
      const Verdict& verdict = analysis.verdicts[r];
      if (!verdict.witness) continue;
      const trace::Trace& run = verdict.witness->trace;
      INFO("seed " << seed << " " << requirement.name << "\n" << text << tail(run));
      REQUIRE(refusal(problem, requirement, *verdict.witness, run) == "");
      REQUIRE(test::unexplained(verdict) == "");
      ++witnesses;
      const bool timed = requirement.measure != Requirement::Measure::load && !verdict.witness->grows &&
                         requirement.measure != Requirement::Measure::loss;
      for (std::size_t e = 0; timed && e < run.events.size(); ++e) {
        trace::Trace late = run;
        ++late.events[e].time_ns;
        trace::Trace early = run;
        --early.events[e].time_ns;
        trace::Trace without = run;
        without.events.erase(without.events.begin() + static_cast<std::ptrdiff_t>(e));
        const auto refused = [&](const trace::Trace& each) {
          return !refusal(problem, requirement, *verdict.witness, each).empty();
        };
        moved.count(refused(late));
        moved.count(refused(early));
        left_out.count(refused(without));
        if (e + 1 < run.events.size()) reordered.count(refused(swapped(run, e)));
      }
    }
  }
  std::cout << witnesses << " witnesses confirmed; refused: " << moved.refused << " of " << moved.made
            << " moved, " << left_out.refused << " of " << left_out.made << " without an event, "
            << reordered.refused << " of " << reordered.made << " reordered\n";
  CHECK(witnesses > 0);
  // What is left over are changes that give another run of the same skill: an event of a device that comes
  // once, the end of an action whose time is not fixed, two things that happen at one instant apart from each
  // other.
  CHECK(moved.refused * 100 > moved.made * 95);
  CHECK(left_out.refused * 100 > left_out.made * 95);
}

TEST_CASE("an age is explained by what the thread read, not by the messages that came since") {
  const auto skill = test::sound_skill(R"(MESSAGE force : REAL N
MESSAGE raw : REAL N
MESSAGE motion : dz : REAL mm
MESSAGE correction : dz : REAL mm
MESSAGE tick : SIGNAL
CONDITION pc-force FROM force "touching"
CONDITION pc-stop             "far enough"
DEVICE sensor "asked for raw forces"
DEVICE robot "asks for corrections"
SKILL random
  SENSOR DRIVER      SD1
  LOGICAL SENSOR     LS1
  MACHINE CONTROLLER MC1
  MODEL DATA         NONE
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL "touching"
  COMPLETION 1 ERROR  "any other error"
  REQUIREMENT age  : AGE OF pc-force AT TXM( motion to MC1 ) IN SM1 AT MOST 18 ms
  REQUIREMENT load : LOAD OF EACH PROCESSOR AT MOST 60 %
  REQUIREMENT answer : RESPONSE FROM tick OF robot TO TXM( correction to robot ) AT MOST 18 ms
  REQUIREMENT more-1 : INTERVAL OF TXM( motion to MC1 ) IN SM1 AT MOST 18 ms
  REQUIREMENT more-2 : INTERVAL OF WTM( raw from SD1 ) IN LS1 BETWEEN 1 ms AND 9 ms
END SKILL
Sensor Driver: SD1
Logical Sensor: LS1
  ACTIVITY extract READS raw WRITES force
BEGIN
  REPEAT
    WTM( request force from SM1 )
    TXM( request raw from SD1 )
    WTM( raw from SD1 )
    extract
    TXM( force to SM1 )
  UNTIL( forever )
END
Machine Controller: MC1
  ACTIVITY obey READS motion WRITES correction
  ACTIVITY hold WRITES correction
BEGIN
  REPEAT
    WTM( tick from robot )
    TXM( request motion from SM1 )
    WTM( motion from SM1 ) WITHIN 5 ms
      obey
    ELSE
      hold
    END WTM
    TXM( correction to robot )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY think
  ACTIVITY prepare
BEGIN
  WTM( Coordinator )
      TXM( request force from LS1 )
      WTM( force from LS1 )
      SPC( pc-force )
  REPEAT
      TXM( request force from LS1 )
      WTM( force from LS1 )
      SPC( pc-force )
      RPC( pc-force )
      WTM( motion request from MC1 )
      CASE
        ( pc-force = TRUE ):
          TXM( motion to MC1 )
        ( pc-force = FALSE ):
          think
          TXM( motion to MC1 )
      END CASE
      SPC( pc-stop )
  UNTIL( pc-stop )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P0
  PROCESSOR P1
  DEVICE SD1 ON REQUEST 1 ms
  DEVICE robot EVENT tick EVERY 6 ms JITTER 1 ms
  PLACE SM1 ON P0 PRIORITY 1
  PLACE LS1 ON P0 PRIORITY 3
  PLACE MC1 ON P0 PRIORITY 3
  TIME extract : 2 ms
  TIME think : 2 ms
  TIME prepare : 0 TO 2 ms
  TIME obey : 1 ms
  TIME hold : 0 TO 2 ms
END ENVIRONMENT
)");
  Options options;
  options.max_states = 2'500;
  const Analysis analysis = analyze(*skill->problem, options);
  const Verdict& age = analysis.verdicts.front();
  REQUIRE(age.witness);
  REQUIRE_FALSE(age.reasons.empty());
  CHECK(test::unexplained(age) == "");
}

TEST_CASE("a thread that goes on at the instant at which it ended keeps its processor busy") {
  const auto skill = test::skill_from_text(R"(CONDITION stop
SKILL spinning
  SENSOR DRIVER NONE
  LOGICAL SENSOR NONE
  MACHINE CONTROLLER NONE
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT pause : BUSY PERIOD OF P0 AT MOST 5 ms
END SKILL
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  SPC( stop )
  REPEAT
  UNTIL( stop )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P0
  PLACE SM1 ON P0 PRIORITY 1
  COST TEST 1 ms
END ENVIRONMENT
)");
  INFO(test::messages(skill->diagnostics));
  REQUIRE(skill->problem);
  const Analysis analysis = analyze(*skill->problem);
  const Verdict& pause = analysis.verdicts.front();
  REQUIRE(pause.state == Verdict::State::fails);
  REQUIRE(pause.witness);
  CHECK(pause.witness->grows);
  CHECK(test::unconfirmed(*skill->problem, analysis) == "");
}

// LS1 gives up while SD1 is receiving an event: the request that it withdraws is not what SD1 receives.
TEST_CASE("a message that is withdrawn beside the one that is being taken leaves that alone") {
  const auto skill = test::sound_skill(R"(MESSAGE m2 : REAL
MESSAGE e3 : REAL
DEVICE d1
SKILL s
  SENSOR DRIVER SD1
  LOGICAL SENSOR LS1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 2 ERROR
  REQUIREMENT r : BUSY PERIOD OF P1 AT MOST 1 s
END SKILL
Logical Sensor: LS1
BEGIN
  REPEAT
    TXM( request m2 from SD1 )
    WTM( m2 from SD1 ) WITHIN 7 ms
      Do Nothing
    ELSE
      Do Nothing
    END WTM
  UNTIL( forever )
END
Sensor Driver: SD1
  ACTIVITY work
BEGIN
  REPEAT
    WTM FIRST
      ( e3 from d1 ):
        work
      ( request m2 from LS1 ):
        TXM( m2 to LS1 )
    END WTM
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY wait-long
BEGIN
  WTM( Coordinator )
  wait-long
  TXM( Completion Protocol 0 )
END
ENVIRONMENT e
  PROCESSOR P0
  PROCESSOR P1
  PROCESSOR P2
  DEVICE d1 EVENT e3 EVERY 5 ms
  PLACE LS1 ON P0 PRIORITY 1
  PLACE SM1 ON P2 PRIORITY 2
  PLACE SD1 ON P1 PRIORITY 1
  TIME wait-long OF SM1 : 1 s
  TIME work OF SD1 : 4 ms
  COST RECEIVE 2 ms
END ENVIRONMENT
)");
  const Watch nothing;
  const Machine machine(*skill->problem, nothing);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SimulationOptions how;
    how.times = SimulationOptions::Times::random;
    how.seed = seed;
    how.until = 100 * millisecond;
    CHECK(rules::check_run(*skill->problem, nullptr, simulate(machine, how).trace).broken == "");
  }
}

namespace {

/// Runs of a skill that the rules refuse, by their seeds.
std::string refused_runs(const std::string& text, SimulationOptions::Times times) {
  const auto skill = test::sound_skill(text);
  const Watch nothing;
  const Machine machine(*skill->problem, nothing);
  std::string refused;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SimulationOptions how;
    how.times = times;
    how.seed = seed;
    how.until = 60 * millisecond;
    const std::string broken = rules::check_run(*skill->problem, nullptr, simulate(machine, how).trace).broken;
    if (!broken.empty()) refused += std::to_string(seed) + ": " + broken + "\n";
  }
  return refused;
}

}  // namespace

// LS1.1 takes the next request, of the instant at which the one before is withdrawn: it did not have that one.
TEST_CASE("a thread that takes the next message need not have had the one that was withdrawn") {
  CHECK(refused_runs(R"(MESSAGE m1 : REAL
MESSAGE m2 : REAL
SKILL s
  LOGICAL SENSOR LS1, LS2
  SKILL METHOD SM1
  CONTINGENCY 1 "c" METHOD CM1
  COMPLETION 2 ERROR
END SKILL
Logical Sensor: LS1
  ACTIVITY work
BEGIN
  CONCURRENT
    BEGIN
      REPEAT
        WTM( request m1 from SM1 )
        TXM( m1 to SM1 )
      UNTIL( forever )
    END
    BEGIN
      REPEAT
        work
      UNTIL( forever )
    END
  END CONCURRENT
END
Logical Sensor: LS2
BEGIN
  REPEAT
    WTM( request m2 from SM1 )
    TXM( m2 to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  REPEAT
    CONCURRENT
      BEGIN
        TXM( request m1 from LS1 )
        WTM( m1 from LS1 )
        Execute CM1
        TXM( request m2 from LS2 )
        WTM( m2 from LS2 ) WITHIN 1 ms
          Do Nothing
        ELSE
          Do Nothing
        END WTM
      END
    END CONCURRENT
  UNTIL( forever )
END
Contingency Module: CM1
BEGIN
  CONCURRENT
    BEGIN
      REPEAT
        TXM( request m1 from LS1 )
        WTM( m1 from LS1 )
      UNTIL( forever )
    END
    BEGIN
      Do Nothing
    END
  END CONCURRENT
END
ENVIRONMENT e
  PROCESSOR P0
  PROCESSOR P1
  PLACE LS1 ON P0 PRIORITY 1
  PLACE LS1.1 ON P0 PRIORITY 2
  PLACE LS2 ON P0 PRIORITY 2
  PLACE SM1 ON P1 PRIORITY 2
  PLACE SM1.1 ON P0 PRIORITY 2
  TIME work OF LS1 : 3 ms
  LATENCY WITHIN PROCESSOR 0 TO 2 ms
END ENVIRONMENT
)", SimulationOptions::Times::extremes) == "");
}

// SM1.1 takes a message, which frees LS1, and ends, which cancels SM1.2: LS1 or SM1 is the first in the queue.
TEST_CASE("a sender that was freed comes to its queue before or after the parent of who freed it") {
  CHECK(refused_runs(R"(MESSAGE m1 : REAL
CONDITION c1
SKILL s
  LOGICAL SENSOR LS1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 2 ERROR
END SKILL
Logical Sensor: LS1
  ACTIVITY work
BEGIN
  REPEAT
    work
    TXM( m1 to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  SPC( c1 )
  CONCURRENT
    BEGIN
      WTM( m1 from LS1 ) WITHIN 2 ms
        Do Nothing
      ELSE
        RPC( c1 )
      END WTM
    END
    BEGIN
      REPEAT
        WTM( m1 from LS1 )
        SPC( c1 )
      UNTIL( forever )
    END
  END CONCURRENT
  TXM( Completion Protocol 0 )
END
ENVIRONMENT e
  PROCESSOR P0
  PLACE LS1 ON P0 PRIORITY 1
  PLACE SM1 ON P0 PRIORITY 1
  TIME work OF LS1 : 3 ms
END ENVIRONMENT
)", SimulationOptions::Times::worst) == "");
}
