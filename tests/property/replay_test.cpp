// The referee and the machine, written apart, must agree on what a run is.
#include <catch2/catch.hpp>
#include <functional>
#include <iostream>
#include <sstream>

#include "analyzer/exact/exact.hpp"
#include "analyzer/run_checker/check_run.hpp"
#include "analyzer/run_checker/witness_file.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/confirm.hpp"
#include "tests/support/mutant.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/silent_devices.hpp"
#include "tests/support/skill.hpp"
#include "tests/support/timed_skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::refusal;
using pal::test::setting;
using pal::test::shows;

namespace {

constexpr Nanoseconds one_millisecond = 1'000'000;

/// A random skill; every third one a timed one that is changed in a few places.
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

namespace {

void expect_rules_kept(std::uint64_t usual_rounds, const std::function<std::string(std::uint64_t)>& text_of) {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", usual_rounds);
  std::size_t events = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    const std::string text = text_of(seed);
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
        options.until = 300 * one_millisecond;
        options.max_events = 1'000;
        const Simulation made = simulate(machine, options);
        const run_checker::Ruling ruling = run_checker::check_run(*skill->problem, &requirement, made.trace);
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

}  // namespace

TEST_CASE("every simulated run keeps the rules, and shows the same values") {
  expect_rules_kept(60, program);
}

TEST_CASE("devices that do not answer: runs keep the rules and show the same values") {
  expect_rules_kept(30, [](std::uint64_t seed) { return test::with_silent_devices(program(seed)); });
}

TEST_CASE("no run that the referee measures exceeds a bound") {
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
    const Analysis analysis = analyze_exactly(problem, options);
    const Watch nothing;
    const Machine machine(problem, nothing);
    for (std::uint64_t run = 0; run < 8; ++run) {
      SimulationOptions how;
      how.times = run % 2 == 0 ? SimulationOptions::Times::random : SimulationOptions::Times::extremes;
      how.seed = seed * 100 + run;
      how.until = 300 * one_millisecond;
      how.max_events = 1'000;
      const Simulation made = simulate(machine, how);
      for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
        const Requirement& requirement = problem.requirements[r];
        const Verdict& verdict = analysis.verdicts[r];
        if (requirement.measure == Requirement::Measure::load) continue;
        const run_checker::Ruling ruling = run_checker::check_run(problem, &requirement, made.trace);
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
  Changes repeated;
  Changes reordered;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    const std::string text = program(seed);
    const auto skill = test::skill_from_text(text);
    if (!skill->problem) continue;
    const Problem& problem = *skill->problem;
    Options options;
    options.max_states = 2'500;
    const Analysis analysis = analyze_exactly(problem, options);
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
        trace::Trace twice = run;
        twice.events.insert(twice.events.begin() + static_cast<std::ptrdiff_t>(e), run.events[e]);
        repeated.count(refused(twice));
        if (e + 1 < run.events.size()) reordered.count(refused(swapped(run, e)));
      }
    }
  }
  std::cout << witnesses << " witnesses confirmed; refused: " << moved.refused << " of " << moved.made
            << " moved, " << left_out.refused << " of " << left_out.made << " without an event, "
            << repeated.refused << " of " << repeated.made << " with one told twice, " << reordered.refused
            << " of " << reordered.made << " reordered\n";
  CHECK(witnesses > 0);
  // Some changes give another run of the same skill. They move an event of a device that comes once, or the
  // end of an action whose time is not fixed. Or they exchange two independent events of one instant.
  CHECK(moved.refused * 100 > moved.made * 95);
  CHECK(left_out.refused * 100 > left_out.made * 95);
  CHECK(repeated.refused == repeated.made);
}
