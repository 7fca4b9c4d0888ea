// The referee alone: runs of which it lets every event pass show no more than was proved of all runs.
#include <catch2/catch.hpp>
#include <functional>
#include <iostream>
#include <sstream>

#include "analyzer/exact/exact.hpp"
#include "analyzer/run_checker/check_run.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/odd_skill.hpp"
#include "tests/support/project_file.hpp"
#include "tests/support/random_cell.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/stopped_blocks.hpp"
#include "tests/support/teller.hpp"
#include "tests/support/timed_skill.hpp"
#include "tests/support/told.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;
using pal::test::Told;
using trace::Kind;

namespace {

std::string told(const trace::Trace& run) {
  std::ostringstream out;
  for (const trace::Event& event : run.events) {
    out << event.time_ns / 1'000'000 << " "
        << (event.actor < 0 ? "-" : run.actors[static_cast<std::size_t>(event.actor)].name) << " "
        << trace::name(event.kind) << " "
        << (event.statement < 0 ? "" : run.statements[static_cast<std::size_t>(event.statement)].text);
    const bool condition = event.kind == trace::Kind::set || event.kind == trace::Kind::read;
    if (event.subject >= 0)
      out << " ["
          << (condition ? run.conditions[static_cast<std::size_t>(event.subject)]
                        : run.channels[static_cast<std::size_t>(event.subject)].message)
          << "]";
    out << " " << event.value << "\n";
  }
  return out.str();
}

/// What the run shows that was proved not to be; empty: nothing.
std::string contradiction(const run_checker::Ruling& ruling, const Verdict& verdict, bool least) {
  const bool load = verdict.measure == Requirement::Measure::load;
  if (load) return {};
  if (verdict.state == Verdict::State::never && !ruling.measured.empty()) return "something is measured";
  if (verdict.state == Verdict::State::holds && ruling.failed) return "an event has no response";
  for (const run_checker::Measured& each : ruling.measured) {
    const Duration value(each.value);
    const auto beyond = [&](Duration limit) { return least ? value < limit : value > limit; };
    if ((verdict.bound && beyond(*verdict.bound)) ||
        (verdict.state == Verdict::State::holds && beyond(verdict.limit)))
      return std::to_string(each.value) + " from " + std::to_string(each.born) + " to " +
             std::to_string(each.at);
  }
  return {};
}

struct ToldTally {
  std::size_t skills = 0;
  std::size_t runs = 0;
  std::size_t events = 0;
  std::size_t values = 0;
};

void expect_sound(const std::string& text, std::uint64_t seed, ToldTally& tally) {
  const auto skill = test::any_skill(text);
  if (!skill->problem) return;
  const Problem& problem = *skill->problem;
  Options options;
  options.max_states = setting("PAL_CLASSES", 2'000);
  const Analysis analysis = analyze_exactly(problem, options);
  if (analysis.zeno_run) return;
  ++tally.skills;
  const Watch nothing;
  const trace::Trace empty = simulate(Machine(problem, nothing), {}).trace;
  for (std::uint64_t run = 0; run < setting("PAL_WALKS", 6); ++run) {
    test::Teller teller(problem, empty, seed * 1000 + run);
    const trace::Trace& made = teller.tell(setting("PAL_EVENTS", 80));
    if (made.events.empty()) continue;
    ++tally.runs;
    tally.events += made.events.size();
    for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
      const Requirement& requirement = problem.requirements[r];
      const run_checker::Ruling ruling = run_checker::check_run(problem, &requirement, made, teller.until());
      INFO("seed " << seed << " run " << run << " " << requirement.name << ": "
                   << analysis.verdicts[r].explanation.text() << "\n"
                   << text << told(made));
      REQUIRE(ruling.broken == "");
      tally.values += ruling.measured.size();
      CHECK(contradiction(ruling, analysis.verdicts[r], requirement.at_least) == "");
    }
  }
}

/// Runs of the machine: the referee lets them pass.
std::size_t confirm(const std::string& text, std::uint64_t seed) {
  const auto skill = test::any_skill(text);
  if (!skill->problem) return 0;
  const Watch nothing;
  const Machine machine(*skill->problem, nothing);
  std::size_t events = 0;
  for (std::uint64_t run = 0; run < 4; ++run) {
    SimulationOptions options;
    options.times = run < 2 ? SimulationOptions::Times::random : SimulationOptions::Times::extremes;
    options.seed = seed * 100 + run;
    options.until = 200'000'000;
    options.max_events = 500;
    const trace::Trace made = simulate(machine, options).trace;
    INFO("seed " << seed << " run " << run << "\n" << text << told(made));
    CHECK(run_checker::check_run(*skill->problem, nullptr, made).broken == "");
    events += made.events.size();
  }
  return events;
}

std::string project(const std::string& name) {
  return test::project_file("tests/differential/told/" + name + ".pal");
}

void take_tick(test::Told& run, int number = 1) {
  const std::string statement = "WTM( tick from d )";
  run.say(Kind::put, "d", {}, "tick", number).say(Kind::start, "MC1", statement);
  run.say(Kind::take, "MC1", statement, "tick", number).say(Kind::done, "MC1", statement);
}

void send(test::Told& run, const std::string& statement, const std::string& message) {
  run.say(Kind::start, "MC1", statement).say(Kind::put, "MC1", statement, message, 1);
  run.say(Kind::done, "MC1", statement);
}

/// For `rounds` skills, if no other number is set.
void expect_all_sound(std::uint64_t rounds, const std::function<std::string(std::uint64_t)>& text) {
  const std::uint64_t first = setting("PAL_SEED", 1);
  ToldTally tally;
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", rounds); ++seed)
    expect_sound(text(seed), seed, tally);
  std::cout << tally.skills << " skills, " << tally.runs << " runs told, " << tally.events << " events, "
            << tally.values << " values\n";
  CHECK(tally.values > 0);
}

}  // namespace

TEST_CASE("no run of a cell that the referee accepts exceeds a bound") {
  expect_all_sound(12, [](std::uint64_t seed) {
    return test::RandomCell(seed, 4, static_cast<int>(seed % 3), test::RandomCell::Asks::all).text();
  });
}

TEST_CASE("no run with stopped blocks that the referee accepts exceeds a bound") {
  expect_all_sound(12, [](std::uint64_t seed) { return test::StoppedBlocks(seed).text(); });
}

TEST_CASE("no run of a timed skill that the referee accepts exceeds a bound") {
  expect_all_sound(12, [](std::uint64_t seed) { return test::TimedSkill(seed).text(); });
}

TEST_CASE("the referee accepts every simulated run of odd skills") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  std::size_t events = 0;
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 15); ++seed) {
    events += confirm(test::RandomCell(seed, 4, static_cast<int>(seed % 3)).text(), seed);
    events += confirm(test::StoppedBlocks(seed).text(), seed);
    events += confirm(test::OddSkill(seed).text(), seed);
  }
  std::cout << events << " events\n";
  CHECK(events > 0);
}

TEST_CASE("a thread with a message and the greater priority goes first") {
  // Else SM1 would read what MC1 sets after it has sent, and work for 50 ms.
  const auto begun = [] {
    test::Told run(project("overtaken"));
    run.say(Kind::block, "SM1", "WTM( m from MC1 )", "m")
        .say(Kind::block, "MC1", "WTM( tick from d )", "tick");
    take_tick(run);
    send(run, "TXM( m to SM1 )", "m");
    return run;
  };
  const auto take_m = [](test::Told& run) {
    const std::string wait = "WTM( m from MC1 )";
    run.say(Kind::take, "SM1", wait, "m", 1).say(Kind::done, "SM1", wait).say(Kind::start, "SM1", "CASE");
  };
  test::Told first = begun();
  first.say(Kind::start, "SM1", "WTM( m from MC1 )").say(Kind::ready, "MC1", "SPC( c = TRUE )");
  take_m(first);
  first.say(Kind::read, "SM1", "CASE", "c", 0).say(Kind::done, "SM1", "CASE");
  first.say(Kind::start, "SM1", "TXM( Completion Protocol 0 )");
  CHECK(first.broken() == "");

  test::Told overtaken = begun();
  overtaken.say(Kind::start, "MC1", "SPC( c = TRUE )").say(Kind::set, "MC1", "SPC( c = TRUE )", "c", 1);
  overtaken.say(Kind::done, "MC1", "SPC( c = TRUE )").say(Kind::start, "SM1", "WTM( m from MC1 )");
  take_m(overtaken);
  overtaken.say(Kind::read, "SM1", "CASE", "c", 1).say(Kind::done, "SM1", "CASE");
  CHECK(overtaken.broken() == "at 0 ns: SM1 waits for a message that is there");
}

TEST_CASE("a sender goes on when its slot becomes free") {
  const std::string send_m = "TXM( m to SM1 )";
  const std::string wait = "WTM( m from MC1 )";
  const std::string tick = "WTM( tick from d )";
  const auto freed = [&](int later) {
    test::Told run(project("freed"));
    run.say(Kind::start, "SM1", "work").say(Kind::block, "MC1", tick, "tick");
    take_tick(run, 1);
    send(run, send_m, "m");
    run.say(Kind::block, "MC1", tick, "tick").at(20);
    take_tick(run, 2);
    run.say(Kind::start, "MC1", send_m).say(Kind::block, "MC1", send_m, "m").at(30);
    run.say(Kind::done, "SM1", "work").say(Kind::start, "SM1", wait).say(Kind::take, "SM1", wait, "m", 1);
    run.say(Kind::put, "MC1", send_m, "m", 2);
    if (later == 0) run.say(Kind::done, "MC1", send_m).say(Kind::block, "MC1", tick, "tick");
    run.say(Kind::done, "SM1", wait).say(Kind::start, "SM1", "work").at(30 + later);
    if (later > 0) run.say(Kind::done, "MC1", send_m).say(Kind::block, "MC1", tick, "tick");
    return run.broken();
  };
  CHECK(freed(0) == "");
  CHECK(freed(2) == "at 30000000 ns: MC1 does half of a statement");
}

TEST_CASE("a request is withdrawn by a wait that gives up, and not before") {
  // Else SM1 would have nothing to take, let MC1 go on, and so be the reason that it gives up.
  const std::string asked = "WTM( request m from MC1 )";
  test::Told run(project("early"));
  run.say(Kind::block, "SM1", asked, "request m").say(Kind::block, "MC1", "WTM( tick from d )", "tick");
  take_tick(run);
  send(run, "TXM( request m from SM1 )", "request m");
  run.say(Kind::drop, "-", {}, "request m", 1).say(Kind::start, "SM1", asked);
  run.say(Kind::block, "SM1", asked, "request m");
  run.say(Kind::give_up, "MC1", "WTM( m from SM1 ) WITHIN 0 ms", "m");
  CHECK(run.broken() == "at 0 ns: SM1 waits for a message that is there");
}
