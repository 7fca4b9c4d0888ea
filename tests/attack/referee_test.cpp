// Runs that cannot be, told event by event: the referee refuses them.
#include <catch2/catch.hpp>

#include "analyzer/replay/check_run.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/told.hpp"

using namespace pal;
using namespace pal::analyzer;
using test::Told;
using trace::Kind;

namespace {

/// MC1 sets c1 and then c2; SM1 tests both on another processor. Nothing takes time.
const char* const two_conditions = R"(MESSAGE m : SIGNAL
CONDITION c1
CONDITION c2
SKILL odd
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 2 ERROR
  REQUIREMENT r : DURATION TO COMPLETION 0 AT MOST 1 s
END SKILL
Machine Controller: MC1
BEGIN
  SPC( c1 = TRUE )
  SPC( c2 = TRUE )
  WTM( m from SM1 )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  CASE
    ( c2 AND NOT c1 ):
      TXM( Completion Protocol 2 )
    ( NOT c2 OR c1 ):
      TXM( m to MC1 )
      TXM( Completion Protocol 0 )
  END CASE
END
ENVIRONMENT cell
  PROCESSOR P
  PROCESSOR Q
  PLACE SM1 ON P PRIORITY 1
  PLACE MC1 ON Q PRIORITY 1
END ENVIRONMENT
)";

/// MC1 receives for 1 ms; a tick comes each 1 ms.
const char* const two_waits = R"(MESSAGE m : SIGNAL
MESSAGE tick : SIGNAL
DEVICE d
SKILL odd
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 2 ERROR
  REQUIREMENT r : DURATION TO COMPLETION 0 AT MOST 1 s
END SKILL
Machine Controller: MC1
BEGIN
  WTM( tick from d )
  WTM( tick from d ) WITHIN 0 ms
    Do Nothing
  ELSE
    Do Nothing
  END WTM
  TXM( m to SM1 )
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  WTM( m from MC1 )
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P
  PLACE SM1 ON P PRIORITY 1
  PLACE MC1 ON P PRIORITY 1
  DEVICE d EVENT tick EVERY 1 ms PHASE 0 ms
  COST RECEIVE 1 ms
END ENVIRONMENT
)";

/// Both threads have a processor each.
void start_both(Told& run) {
  run.say(Kind::start, "SM1", "CASE").say(Kind::start, "MC1", "SPC( c1 = TRUE )");
}

void set_both(Told& run) {
  run.say(Kind::set, "MC1", "SPC( c1 = TRUE )", "c1", 1).say(Kind::done, "MC1", "SPC( c1 = TRUE )");
  run.say(Kind::start, "MC1", "SPC( c2 = TRUE )").say(Kind::set, "MC1", "SPC( c2 = TRUE )", "c2", 1);
  run.say(Kind::done, "MC1", "SPC( c2 = TRUE )");
  run.say(Kind::block, "MC1", "WTM( m from SM1 )", "m");
}

void complete(Told& run, const std::string& code) {
  const std::string statement = "TXM( Completion Protocol " + code + " )";
  run.say(Kind::start, "SM1", statement).say(Kind::complete, "SM1", statement, {}, code == "0" ? 0 : 2);
  run.say(Kind::done, "SM1", statement);
}

}  // namespace

TEST_CASE("a test reads all its conditions at one instant: nobody sets one between") {
  Told before(two_conditions);
  start_both(before);
  before.say(Kind::read, "SM1", "CASE", "c1", 0);
  before.say(Kind::read, "SM1", "CASE", "c2", 0).say(Kind::done, "SM1", "CASE");
  before.say(Kind::start, "SM1", "TXM( m to MC1 )");
  set_both(before);
  CHECK(before.broken() == "");

  // c2 is set after c1, so whoever reads TRUE of c2 reads TRUE of c1.
  Told between(two_conditions);
  start_both(between);
  between.say(Kind::read, "SM1", "CASE", "c1", 0);
  set_both(between);
  between.say(Kind::read, "SM1", "CASE", "c2", 1).say(Kind::done, "SM1", "CASE");
  complete(between, "2");
  CHECK(between.broken() == "at 0 ns: SM1 is interrupted in its effect");
}

TEST_CASE("a test reads each condition once") {
  Told twice(two_conditions);
  start_both(twice);
  twice.say(Kind::read, "SM1", "CASE", "c1", 0);
  twice.say(Kind::read, "SM1", "CASE", "c1", 0).say(Kind::read, "SM1", "CASE", "c2", 0);
  twice.say(Kind::done, "SM1", "CASE");
  set_both(twice);
  CHECK(twice.broken() == "at 0 ns: SM1 reads a condition twice");
}

TEST_CASE("a thread that has taken a message comes to its next wait before another one can be there") {
  const std::string first = "WTM( tick from d )";
  const std::string second = "WTM( tick from d ) WITHIN 0 ms";
  const auto begun = [&] {
    Told run(two_waits);
    run.say(Kind::block, "MC1", first, "tick").say(Kind::block, "SM1", "WTM( m from MC1 )", "m");
    run.say(Kind::put, "d", {}, "tick", 1).say(Kind::start, "MC1", first).at(1);
    return run;
  };

  Told before = begun();
  before.say(Kind::overrun, "d", {}, "tick").say(Kind::take, "MC1", first, "tick", 1);
  before.say(Kind::done, "MC1", first).say(Kind::give_up, "MC1", second, "tick");
  before.say(Kind::start, "MC1", second);
  CHECK(before.broken() == "");

  Told after = begun();
  after.say(Kind::take, "MC1", first, "tick", 1).say(Kind::done, "MC1", first);
  after.say(Kind::give_up, "MC1", second, "tick").say(Kind::start, "MC1", second);
  after.say(Kind::put, "d", {}, "tick", 2);
  CHECK(after.broken() == "");

  Told between = begun();
  between.say(Kind::take, "MC1", first, "tick", 1).say(Kind::put, "d", {}, "tick", 2);
  between.say(Kind::done, "MC1", first).say(Kind::start, "MC1", second);
  CHECK(between.broken() == "at 1000000 ns: MC1 is interrupted in its effect");
}

TEST_CASE("a message of a freed sender comes after its receiver has chosen the next one") {
  // MC1 takes m, and finds a tick at its next wait; then SM1, which was blocked, puts the next m.
  const auto skill = test::any_skill(R"(MESSAGE m : SIGNAL
MESSAGE tick : SIGNAL
DEVICE d
SKILL odd
  MACHINE CONTROLLER MC1
  SKILL METHOD SM1
  COMPLETION 2 ERROR
  REQUIREMENT r : LOAD OF P AT MOST 100 %
END SKILL
Machine Controller: MC1
BEGIN
  REPEAT
    WTM FIRST
      ( m from SM1 ):
        Do Nothing
      ( tick from d ):
        Do Nothing
    END WTM
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
  REPEAT
    TXM( m to MC1 )
    TXM( m to MC1 )
    work
  UNTIL( forever )
END
ENVIRONMENT cell
  PROCESSOR P
  PLACE SM1 ON P PRIORITY 1
  PLACE MC1 ON P PRIORITY 1
  DEVICE d EVENT tick EVERY 2 ms
  TIME work : 1 ms
END ENVIRONMENT
)");
  INFO(test::messages(skill->diagnostics));
  REQUIRE(skill->problem);
  const Watch nothing;
  const Machine machine(*skill->problem, nothing);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SimulationOptions options;
    options.times = SimulationOptions::Times::random;
    options.seed = seed;
    options.until = 60'000'000;
    const trace::Trace run = simulate(machine, options).trace;
    INFO("seed " << seed);
    CHECK(rules::check_run(*skill->problem, &skill->problem->requirements.front(), run).broken == "");
  }
}
