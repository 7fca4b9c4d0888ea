#include "tests/property/sandwich.hpp"

#include <catch2/catch.hpp>
#include <iostream>

#include "analyzer/analysis.hpp"
#include "analyzer/compositional/compositional.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/setting.hpp"

namespace pal::test {

using namespace analyzer;

namespace {

constexpr Nanoseconds millisecond = 1'000'000;

std::string measure_of(const Requirement& requirement) {
  std::string measure = name(requirement.measure);
  const bool known = requirement.measure == Requirement::Measure::age ||
                     requirement.measure == Requirement::Measure::reaction;
  if (known) measure += !requirement.condition.valid() ? " of a sample" : " of a condition";
  return measure + (requirement.at_least ? ", least" : "");
}

/// Whether no run that has `value` contradicts the bound.
bool within(const Verdict& bound, Nanoseconds value) {
  return bound.at_least ? value >= bound.bound->count() : value <= bound.bound->count();
}

void compare_with_exact(const Problem& problem, const Analysis& compositional, std::size_t most,
                        Tally& tally) {
  Options options;
  options.max_states = most;
  options.threads = 1;
  const Analysis exact = analyze_exactly(problem, options);
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
    const Verdict& above = compositional.verdicts[r];
    const Verdict& below = exact.verdicts[r];
    if (!above.bound) continue;
    const bool kept = above.at_least ? *above.bound >= above.limit : *above.bound <= above.limit;
    REQUIRE((above.state == Verdict::State::holds) == kept);
    INFO(above.requirement << ": compositional " << above.bound->count() << ", exact "
                           << (below.bound ? below.bound->count() : -1) << " " << name(below.state) << ", "
                           << below.explanation.text());
    // What fails for want of a bound has a run without a response, or one above the limit.
    if (below.state == Verdict::State::fails) {
      REQUIRE(above.state != Verdict::State::holds);
      const bool lost = below.witness && below.witness->failed;
      REQUIRE_FALSE(lost);
      if (below.witness) REQUIRE(within(above, below.witness->measured.value));
    }
    if (!below.exact || !below.bound) continue;
    Tally::Of& of = tally.of[measure_of(problem.requirements[r])];
    ++of.exact;
    of.equal += below.bound == above.bound ? 1 : 0;
    REQUIRE(within(above, below.bound->count()));
  }
}

/// A value that still grows at the end of a run counts as it is then.
bool compare_with_run(const Machine& machine, const Verdict& verdict, std::uint64_t seed, std::uint64_t run) {
  SimulationOptions options;
  options.times = run == 0  ? SimulationOptions::Times::worst
                  : run < 3 ? SimulationOptions::Times::random
                            : SimulationOptions::Times::extremes;
  options.seed = seed * 100 + run;
  options.until = 150 * millisecond;
  options.max_events = 1'500;
  options.record = false;
  const Simulation made = simulate(machine, options);
  INFO(verdict.requirement << ": compositional " << verdict.bound->count() << ", run " << run);
  REQUIRE_FALSE(made.failed);
  for (const Measurement& measured : made.measured) REQUIRE(within(verdict, measured.value));
  if (machine.watch().grows() && !made.ended) REQUIRE(made.grown <= verdict.bound->count());
  return !made.measured.empty();
}

void compare_with_runs(const Problem& problem, const Analysis& compositional, std::uint64_t seed,
                       Tally& tally) {
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
    const Requirement& requirement = problem.requirements[r];
    const Verdict& verdict = compositional.verdicts[r];
    if (requirement.measure == Requirement::Measure::load || !verdict.bound) continue;
    const Watch watch = watch_of(problem, requirement);
    const Machine machine(problem, watch);
    bool any = false;
    for (std::uint64_t run = 0; run < 6; ++run) any = compare_with_run(machine, verdict, seed, run) || any;
    tally.of[measure_of(requirement)].simulated += any ? 1 : 0;
  }
}

/// What is said to add up to a bound must do so.
void expect_arithmetic(const Analysis& analysis) {
  for (const Verdict& verdict : analysis.verdicts) {
    if (!verdict.bound || verdict.addends.empty()) continue;
    Nanoseconds sum = 0;
    for (const Addend& each : verdict.addends) sum += each.amount;
    INFO(verdict.requirement);
    REQUIRE(sum == verdict.bound->count());
  }
}

}  // namespace

void expect_sandwich(const Problem& problem, std::uint64_t seed, std::size_t states, Tally& tally) {
  const Analysis compositional = compositional::analyze(problem);
  expect_arithmetic(compositional);
  ++tally.programs;
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
    Tally::Of& of = tally.of[measure_of(problem.requirements[r])];
    ++of.requirements;
    of.bounds += compositional.verdicts[r].bound ? 1 : 0;
  }
  compare_with_runs(problem, compositional, seed, tally);
  const std::size_t most = setting("PAL_STATES", states);
  if (most > 0) compare_with_exact(problem, compositional, most, tally);
}

void say(const Tally& tally) {
  std::cout << tally.programs << " programs\n";
  for (const auto& [measure, of] : tally.of) {
    std::cout << "  " << measure << ": " << of.requirements << " required, " << of.bounds << " bounds; "
              << of.simulated << " compared with runs, " << of.exact << " with exact bounds, " << of.equal
              << " equal\n";
  }
  CHECK(tally.programs > 0);
}

Tally compare_by_chance(std::uint64_t rounds, std::size_t states,
                        const std::function<std::string(std::uint64_t)>& text_of,
                        const std::function<std::unique_ptr<Skill>(const std::string&)>& skill_of,
                        Part part) {
  Tally tally;
  for (const std::uint64_t seed : seeds(1, rounds, part)) {
    const std::string text = text_of(seed);
    INFO("seed " << seed << "\n" << text);
    const auto skill = skill_of(text);
    if (skill->problem) expect_sandwich(*skill->problem, seed, states, tally);
  }
  say(tally);
  return tally;
}

bool usual(std::uint64_t rounds) {
  return setting("PAL_SEED", 1) == 1 && setting("PAL_ROUNDS", rounds) == rounds;
}

}  // namespace pal::test
