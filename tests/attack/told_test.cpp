// The referee alone: runs of which it lets every event pass show no more than was proved of all runs.
#include <catch2/catch.hpp>
#include <iostream>
#include <sstream>

#include "analyzer/exact/exact.hpp"
#include "analyzer/replay/check_run.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/odd_skill.hpp"
#include "tests/support/random_cell.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/stopped_blocks.hpp"
#include "tests/support/teller.hpp"
#include "tests/support/timed_skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;

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
      out << " [" << (condition ? run.conditions[static_cast<std::size_t>(event.subject)]
                                : run.channels[static_cast<std::size_t>(event.subject)].message)
          << "]";
    out << " " << event.value << "\n";
  }
  return out.str();
}

/// What the run shows that was proved not to be; empty: nothing.
std::string contradiction(const rules::Ruling& ruling, const Verdict& verdict, bool least) {
  const bool load = verdict.measure == Requirement::Measure::load;
  if (load) return {};
  if (verdict.state == Verdict::State::never && !ruling.measured.empty()) return "something is measured";
  if (verdict.state == Verdict::State::holds && ruling.failed) return "an event has no response";
  for (const rules::Measured& each : ruling.measured) {
    const Duration value(each.value);
    const auto beyond = [&](Duration limit) { return least ? value < limit : value > limit; };
    if ((verdict.bound && beyond(*verdict.bound)) ||
        (verdict.state == Verdict::State::holds && beyond(verdict.limit)))
      return std::to_string(each.value) + " from " + std::to_string(each.born) + " to " +
             std::to_string(each.at);
  }
  return {};
}

struct Tally {
  std::size_t skills = 0;
  std::size_t runs = 0;
  std::size_t events = 0;
  std::size_t values = 0;
};

void attack(const std::string& text, std::uint64_t seed, Tally& tally) {
  const auto skill = test::any_skill(text);
  if (!skill->problem) return;
  const Problem& problem = *skill->problem;
  Options options;
  options.max_states = setting("PAL_CLASSES", 2'000);
  const Analysis analysis = analyze(problem, options);
  if (analysis.standstill) return;
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
      const rules::Ruling ruling = rules::check_run(problem, &requirement, made, teller.until());
      INFO("seed " << seed << " run " << run << " " << requirement.name << ": "
                   << analysis.verdicts[r].explanation << "\n"
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
    CHECK(rules::check_run(*skill->problem, nullptr, made).broken == "");
    events += made.events.size();
  }
  return events;
}

void say(const Tally& tally) {
  std::cout << tally.skills << " skills, " << tally.runs << " runs told, " << tally.events << " events, "
            << tally.values << " values\n";
  CHECK(tally.values > 0);
}

}  // namespace

TEST_CASE("no run of a cell that the referee lets pass shows more than was proved") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  Tally tally;
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 30); ++seed)
    attack(test::RandomCell(seed, 4, static_cast<int>(seed % 3), test::RandomCell::Asks::all).text(), seed,
           tally);
  say(tally);
}

TEST_CASE("no run with stopped blocks that the referee lets pass shows more than was proved") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  Tally tally;
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 30); ++seed)
    attack(test::StoppedBlocks(seed).text(), seed, tally);
  say(tally);
}

TEST_CASE("no run of a timed skill that the referee lets pass shows more than was proved") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  Tally tally;
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 20); ++seed)
    attack(test::TimedSkill(seed).text(), seed, tally);
  say(tally);
}

TEST_CASE("the referee lets every simulated run of odd skills pass") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  std::size_t events = 0;
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 100); ++seed) {
    events += confirm(test::RandomCell(seed, 4, static_cast<int>(seed % 3)).text(), seed);
    events += confirm(test::StoppedBlocks(seed).text(), seed);
    events += confirm(test::OddSkill(seed).text(), seed);
  }
  std::cout << events << " events\n";
  CHECK(events > 0);
}
