// The referee and the machine, written apart, must agree on what a run is.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>
#include <sstream>

#include "analyzer/exact.hpp"
#include "analyzer/replay/check_run.hpp"
#include "analyzer/replay/witness_file.hpp"
#include "analyzer/simulate.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

constexpr Nanoseconds millisecond = 1'000'000;

std::uint64_t setting(const char* name, std::uint64_t usual) {
  const char* value = std::getenv(name);
  return value == nullptr ? usual : std::strtoull(value, nullptr, 10);
}

bool shows(const rules::Ruling& ruling, const Measurement& measured) {
  for (const rules::Measured& each : ruling.measured) {
    if (each.value == measured.value && each.born == measured.born && each.at == measured.at) return true;
  }
  return false;
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

/// Whether `run` is refused, or does not show the same any more.
bool refuted(const Problem& problem, const Requirement& requirement, const Witness& witness,
             const trace::Trace& run) {
  const auto until = witness.grows ? std::optional(witness.measured.at) : std::nullopt;
  const rules::Ruling ruling = rules::check_run(problem, &requirement, run, until);
  if (!ruling.broken.empty()) return true;
  if (witness.grows) {
    return !ruling.growing_since || witness.measured.at - *ruling.growing_since < witness.measured.value;
  }
  return !(witness.failed ? ruling.failed : shows(ruling, witness.measured));
}

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
    const std::string text = test::RandomSkill(seed, 9).text();
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

TEST_CASE("the referee confirms every witness, and no changed one") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 20);
  std::size_t witnesses = 0;
  std::size_t changed = 0;
  std::size_t refused = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    const std::string text = test::RandomSkill(seed, 9).text();
    const auto skill = test::skill_from_text(text);
    if (!skill->problem) continue;
    const Problem& problem = *skill->problem;
    Options options;
    options.max_states = 4'000;
    const Analysis analysis = analyze(problem, options);
    for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
      const Requirement& requirement = problem.requirements[r];
      const Verdict& verdict = analysis.verdicts[r];
      if (!verdict.witness) continue;
      const trace::Trace& run = verdict.witness->trace;
      const rules::Ruling ruling = rules::check_run(problem, &requirement, run);
      INFO("seed " << seed << " " << requirement.name << "\n" << text << tail(run));
      REQUIRE(ruling.broken == "");
      ++witnesses;
      if (requirement.measure == Requirement::Measure::load) continue;
      REQUIRE_FALSE(refuted(problem, requirement, *verdict.witness, run));
      for (std::size_t e = 0; e < run.events.size(); ++e) {
        trace::Trace late = run;
        ++late.events[e].time_ns;
        trace::Trace early = run;
        --early.events[e].time_ns;
        trace::Trace without = run;
        without.events.erase(without.events.begin() + static_cast<std::ptrdiff_t>(e));
        changed += 3;
        for (const trace::Trace& each : {late, early, without}) {
          refused += refuted(problem, requirement, *verdict.witness, each) ? 1 : 0;
        }
      }
    }
  }
  std::cout << witnesses << " witnesses confirmed; " << refused << " of " << changed
            << " changed ones refused\n";
  CHECK(witnesses > 0);
  // What is left over are changes that give another run of the same skill: an event of a device that comes
  // once, the end of an action whose time is not fixed.
  CHECK(refused * 100 > changed * 95);
}
