// Runs that cannot be, told event by event: the referee refuses them.
#include <catch2/catch.hpp>

#include "analyzer/replay/check_run.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/project_file.hpp"
#include "tests/support/told.hpp"

using namespace pal;
using namespace pal::analyzer;
using test::Told;
using trace::Kind;

namespace {

/// The text of the skill in tests/attack/referee of this name.
std::string skill(const std::string& name) {
  return test::project_file("tests/attack/referee/" + name + ".pal");
}

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

// MC1 sets c1 and then c2; SM1 tests both on another processor. Nothing takes time.
TEST_CASE("a test reads all its conditions at one instant: nobody sets one between") {
  Told before(skill("two_conditions"));
  start_both(before);
  before.say(Kind::read, "SM1", "CASE", "c1", 0);
  before.say(Kind::read, "SM1", "CASE", "c2", 0).say(Kind::done, "SM1", "CASE");
  before.say(Kind::start, "SM1", "TXM( m to MC1 )");
  set_both(before);
  CHECK(before.broken() == "");

  // c2 is set after c1, so whoever reads TRUE of c2 reads TRUE of c1.
  Told between(skill("two_conditions"));
  start_both(between);
  between.say(Kind::read, "SM1", "CASE", "c1", 0);
  set_both(between);
  between.say(Kind::read, "SM1", "CASE", "c2", 1).say(Kind::done, "SM1", "CASE");
  complete(between, "2");
  CHECK(between.broken() == "at 0 ns: SM1 is interrupted in its effect");
}

TEST_CASE("a test reads each condition once") {
  Told twice(skill("two_conditions"));
  start_both(twice);
  twice.say(Kind::read, "SM1", "CASE", "c1", 0);
  twice.say(Kind::read, "SM1", "CASE", "c1", 0).say(Kind::read, "SM1", "CASE", "c2", 0);
  twice.say(Kind::done, "SM1", "CASE");
  set_both(twice);
  CHECK(twice.broken() == "at 0 ns: SM1 reads a condition twice");
}

// MC1 receives for 1 ms; a tick comes each 1 ms.
TEST_CASE("a thread that has taken a message comes to its next wait before another one can be there") {
  const std::string first = "WTM( tick from d )";
  const std::string second = "WTM( tick from d ) WITHIN 0 ms";
  const auto begun = [&] {
    Told run(skill("two_waits"));
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
  const auto freed = test::meaningful_skill(skill("freed_sender"));
  const Watch nothing;
  const Machine machine(*freed->problem, nothing);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SimulationOptions options;
    options.times = SimulationOptions::Times::random;
    options.seed = seed;
    options.until = 60'000'000;
    const trace::Trace run = simulate(machine, options).trace;
    INFO("seed " << seed);
    CHECK(rules::check_run(*freed->problem, &freed->problem->requirements.front(), run).broken == "");
  }
}
