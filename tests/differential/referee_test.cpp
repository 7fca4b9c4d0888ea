// Runs that cannot be, told event by event: the referee refuses them.
#include <catch2/catch.hpp>

#include "analyzer/run_checker/check_run.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/project_file.hpp"
#include "tests/support/told.hpp"

using namespace pal;
using namespace pal::analyzer;
using trace::Kind;

namespace {

/// The text of the skill in tests/differential/referee of this name.
std::string skill(const std::string& name) {
  return test::project_file("tests/differential/referee/" + name + ".pal");
}

/// Both threads have a processor each.
void start_both(test::Told& run) {
  run.say(Kind::start, "SM1", "CASE").say(Kind::start, "MC1", "SPC( c1 = TRUE )");
}

void set_both(test::Told& run) {
  run.say(Kind::set, "MC1", "SPC( c1 = TRUE )", "c1", 1).say(Kind::done, "MC1", "SPC( c1 = TRUE )");
  run.say(Kind::start, "MC1", "SPC( c2 = TRUE )").say(Kind::set, "MC1", "SPC( c2 = TRUE )", "c2", 1);
  run.say(Kind::done, "MC1", "SPC( c2 = TRUE )");
  run.say(Kind::block, "MC1", "WTM( m from SM1 )", "m");
}

/// The referee lets forty random runs pass.
void expect_simulated(const std::string& name) {
  const auto made = test::meaningful_skill(skill(name));
  const Watch nothing;
  const Machine machine(*made->problem, nothing);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SimulationOptions options;
    options.times = SimulationOptions::Times::random;
    options.seed = seed;
    options.until = 60'000'000;
    const trace::Trace run = simulate(machine, options).trace;
    INFO("seed " << seed);
    CHECK(run_checker::check_run(*made->problem, &made->problem->requirements.front(), run).broken == "");
  }
}

void complete(test::Told& run, const std::string& code) {
  const std::string statement = "TXM( Completion Protocol " + code + " )";
  run.say(Kind::start, "SM1", statement).say(Kind::complete, "SM1", statement, {}, code == "0" ? 0 : 2);
  run.say(Kind::done, "SM1", statement);
}

}  // namespace

// MC1 sets c1 and then c2; SM1 tests both on another processor. Nothing takes time.
TEST_CASE("a test reads all its conditions at one instant") {
  test::Told before(skill("two_conditions"));
  start_both(before);
  before.say(Kind::read, "SM1", "CASE", "c1", 0);
  before.say(Kind::read, "SM1", "CASE", "c2", 0).say(Kind::done, "SM1", "CASE");
  before.say(Kind::start, "SM1", "TXM( m to MC1 )");
  set_both(before);
  CHECK(before.broken() == "");

  // c2 is set after c1, so a thread that reads TRUE of c2 reads TRUE of c1.
  test::Told between(skill("two_conditions"));
  start_both(between);
  between.say(Kind::read, "SM1", "CASE", "c1", 0);
  set_both(between);
  between.say(Kind::read, "SM1", "CASE", "c2", 1).say(Kind::done, "SM1", "CASE");
  complete(between, "2");
  CHECK(between.broken() == "at 0 ns: SM1 is interrupted in its effect");
}

TEST_CASE("a test reads each condition once") {
  test::Told twice(skill("two_conditions"));
  start_both(twice);
  twice.say(Kind::read, "SM1", "CASE", "c1", 0);
  twice.say(Kind::read, "SM1", "CASE", "c1", 0).say(Kind::read, "SM1", "CASE", "c2", 0);
  twice.say(Kind::done, "SM1", "CASE");
  set_both(twice);
  CHECK(twice.broken() == "at 0 ns: SM1 reads a condition twice");
}

// MC1 receives for 1 ms; a tick comes each 1 ms.
TEST_CASE("after a take a thread reaches its next wait before another message comes") {
  const std::string first = "WTM( tick from d )";
  const std::string second = "WTM( tick from d ) WITHIN 0 ms";
  const auto begun = [&] {
    test::Told run(skill("two_waits"));
    run.say(Kind::block, "MC1", first, "tick").say(Kind::block, "SM1", "WTM( m from MC1 )", "m");
    run.say(Kind::put, "d", {}, "tick", 1).say(Kind::start, "MC1", first).at(1);
    return run;
  };

  test::Told before = begun();
  before.say(Kind::overrun, "d", {}, "tick").say(Kind::take, "MC1", first, "tick", 1);
  before.say(Kind::done, "MC1", first).say(Kind::give_up, "MC1", second, "tick");
  before.say(Kind::start, "MC1", second);
  CHECK(before.broken() == "");

  test::Told after = begun();
  after.say(Kind::take, "MC1", first, "tick", 1).say(Kind::done, "MC1", first);
  after.say(Kind::give_up, "MC1", second, "tick").say(Kind::start, "MC1", second);
  after.say(Kind::put, "d", {}, "tick", 2);
  CHECK(after.broken() == "");

  test::Told between = begun();
  between.say(Kind::take, "MC1", first, "tick", 1).say(Kind::put, "d", {}, "tick", 2);
  between.say(Kind::done, "MC1", first).say(Kind::start, "MC1", second);
  CHECK(between.broken() == "at 1000000 ns: MC1 is interrupted in its effect");
}

// MC1.1 gets ready for 2 ms and asks; MC1.2 waits for the answer for 2 ms, on another processor.
TEST_CASE("an idle device has taken a request before anything else has its effect") {
  const std::string wait = "WTM( x from d ) WITHIN 2 ms";
  const auto asked = [&] {
    test::Told run(skill("idle_device"));
    run.say(Kind::block, "MC1", "CONCURRENT").say(Kind::start, "MC1.1", "get-ready");
    run.say(Kind::block, "MC1.2", wait, "x").say(Kind::start, "SM1", "work").at(2);
    run.say(Kind::done, "MC1.1", "get-ready").say(Kind::start, "MC1.1", "TXM( request x from d )");
    run.say(Kind::give_up, "MC1.2", wait, "x").say(Kind::start, "MC1.2", wait);
    run.say(Kind::put, "MC1.1", "TXM( request x from d )", "request x", 1);
    run.say(Kind::done, "MC1.1", "TXM( request x from d )").say(Kind::start, "MC1.1", "rest");
    return run;
  };

  test::Told taken = asked();
  taken.say(Kind::busy, "d").say(Kind::take, "d", {}, "request x", 1);
  taken.say(Kind::done, "MC1.2", wait);
  CHECK(taken.broken() == "");

  test::Told withdrawn = asked();
  withdrawn.say(Kind::drop, "-", {}, "request x", 1).say(Kind::done, "MC1.2", wait);
  CHECK(withdrawn.broken() == "at 2000000 ns: d is idle while it has a request");

  test::Told before = asked();
  before.say(Kind::done, "MC1.2", wait);
  before.say(Kind::busy, "d").say(Kind::take, "d", {}, "request x", 1);
  CHECK(before.broken() == "at 2000000 ns: d is idle while it has a request");
}

TEST_CASE("blocks come to their queue in the order of the text") {
  const std::string look = "WTM( x from d ) WITHIN 0 ms";
  const auto begun = [&] {
    test::Told run(skill("blocks_in_order"));
    run.say(Kind::start, "SM1", "work").say(Kind::start, "MC1", "warm-up");
    run.say(Kind::start, "MC2.1", "one").at(1);
    run.say(Kind::done, "MC1", "warm-up").say(Kind::block, "MC1", "CONCURRENT");
    return run;
  };

  test::Told in_order = begun();
  in_order.say(Kind::give_up, "MC1.2", look, "x").say(Kind::start, "MC1.1", "get-ready").at(3);
  in_order.say(Kind::done, "MC1.1", "get-ready")
      .say(Kind::start, "MC1.2", look)
      .say(Kind::done, "MC1.2", look);
  CHECK(in_order.broken() == "");

  // It is not known yet that the first has come to its queue, nor need it be said.
  test::Told unsaid = begun();
  unsaid.say(Kind::start, "MC1.1", "get-ready").say(Kind::give_up, "MC1.2", look, "x");
  CHECK(unsaid.broken() == "");

  test::Told looks_first = begun();
  looks_first.say(Kind::give_up, "MC1.2", look, "x").say(Kind::start, "MC1.2", look);
  CHECK(looks_first.broken() == "at 1000000 ns: MC1.2 runs before MC1.1, which was first");

  test::Told beginning(skill("blocks_in_order"));
  beginning.say(Kind::start, "MC2.2", "two");
  CHECK(beginning.broken() == "at 0 ns: MC2.2 runs before MC2.1, which was first");
}

// SM1.1 and SM1.2 begin with waits for m, which is there.
TEST_CASE("a block does not leave a message that it finds to a later one") {
  const std::string send = "TXM( m to SM1 )";
  const std::string later = "WTM( m from MC1 ) WITHIN 1 ms";
  const auto forked = [&] {
    test::Told run(skill("earlier_block"));
    run.say(Kind::start, "SM1", "first").say(Kind::start, "MC1", send);
    run.say(Kind::put, "MC1", send, "m", 1).say(Kind::done, "MC1", send).at(2);
    run.say(Kind::done, "SM1", "first").say(Kind::block, "SM1", "CONCURRENT");
    return run;
  };

  test::Told finds = forked();
  finds.say(Kind::start, "SM1.1", "WTM( m from MC1 )").say(Kind::block, "SM1.2", later, "m");
  finds.say(Kind::take, "SM1.1", "WTM( m from MC1 )", "m", 1).say(Kind::done, "SM1.1", "WTM( m from MC1 )");
  CHECK(finds.broken() == "");

  test::Told leaves = forked();
  leaves.say(Kind::start, "SM1.2", later).say(Kind::block, "SM1.1", "WTM( m from MC1 )", "m");
  CHECK(leaves.broken() == "at 2000000 ns: SM1.1 passes over a message that is there");
}

TEST_CASE("a block that is cancelled before it has had the processor does not begin") {
  const auto ended = [&] {
    test::Told run(skill("never_begun"));
    run.say(Kind::start, "SM1", "work").say(Kind::block, "MC1", "CONCURRENT");
    run.say(Kind::start, "MC1.1", "one").at(1).say(Kind::done, "MC1.1", "one");
    return run;
  };

  test::Told stops = ended();
  stops.say(Kind::cancel, "MC1.2", "two");
  CHECK(stops.broken() == "");

  test::Told begins = ended();
  begins.say(Kind::start, "MC1.2", "two")
      .at(2)
      .say(Kind::done, "MC1.2", "two")
      .say(Kind::cancel, "MC1.2", "two");
  CHECK(begins.broken() == "at 1000000 ns: MC1.2 is cancelled and goes on");
}

TEST_CASE("a thread's wait for its blocks is told once, where they begin") {
  test::Told twice(skill("idle_device"));
  twice.say(Kind::block, "MC1", "CONCURRENT").say(Kind::block, "MC1", "CONCURRENT");
  CHECK(twice.broken() == "at 0 ns: MC1 waits for its blocks already");

  test::Told later(skill("idle_device"));
  later.say(Kind::start, "MC1.1", "get-ready");
  later.say(Kind::block, "MC1.2", "WTM( x from d ) WITHIN 2 ms", "x").say(Kind::start, "SM1", "work").at(1);
  later.say(Kind::block, "MC1", "CONCURRENT");
  CHECK(later.broken() == "at 1000000 ns: MC1 waits for its blocks already");
}

TEST_CASE("the message of a freed sender comes after its receiver's next choice") {
  // MC1 takes m, and finds a tick at its next wait; then SM1, which was blocked, puts the next m.
  expect_simulated("freed_sender");
}

TEST_CASE("unrequested frames of several devices end in the order of time") {
  expect_simulated("two_frames");
}

TEST_CASE("a wait ends when its message is put, even if the message is then withdrawn") {
  // SM1.2 sends its request when SM1.1 has ended, and is stopped.
  const auto until_stopped = [] {
    test::Told run(skill("put_and_stopped"));
    run.say(Kind::block, "SM1", "CONCURRENT");
    run.say(Kind::block, "LS1", "WTM( request w from SM1 )", "request w");
    run.say(Kind::start, "SM1.1", "finish").say(Kind::start, "SM1.2", "TXM( request w from LS1 )");
    run.say(Kind::done, "SM1.1", "finish");
    run.say(Kind::put, "SM1.2", "TXM( request w from LS1 )", "request w", 1);
    run.say(Kind::done, "SM1.2", "TXM( request w from LS1 )");
    run.say(Kind::cancel, "SM1.2", "TXM( request w from LS1 )").say(Kind::drop, "-", {}, "request w", 1);
    return run;
  };

  test::Told receives = until_stopped();
  receives.say(Kind::start, "LS1", "WTM( request w from SM1 )").say(Kind::start, "SM1", "rest");
  CHECK(receives.broken() == "");

  test::Told waits = until_stopped();
  waits.say(Kind::start, "SM1", "rest").at(5).say(Kind::done, "SM1", "rest");
  CHECK(waits.broken() == "at 0 ns: LS1 waits for a message that is there");
}
