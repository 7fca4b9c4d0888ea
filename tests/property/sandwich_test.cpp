// What simulation shows <= what exact analysis proves <= what compositional analysis proves, of any program.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/simulate.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;

namespace {

constexpr Nanoseconds millisecond = 1'000'000;

/// PAL_SEED and PAL_ROUNDS in the environment make a run longer, or another one; PAL_STATES says how many
/// classes the exact analysis may take.
std::uint64_t setting(const char* name, std::uint64_t usual) {
  const char* value = std::getenv(name);
  return value == nullptr ? usual : std::strtoull(value, nullptr, 10);
}

struct Tally {
  std::size_t programs = 0;
  std::size_t requirements = 0;
  std::size_t bounds = 0;    // compositional ones
  std::size_t compared = 0;  // with exact ones
  std::size_t equal = 0;
};

void compare_with_exact(const Problem& problem, const Analysis& compositional, std::size_t most,
                        Tally& tally) {
  Options options;
  options.max_states = most;
  const Analysis exact = analyze(problem, options);
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
    const Verdict& above = compositional.verdicts[r];
    const Verdict& below = exact.verdicts[r];
    if (!above.bound) continue;
    INFO(above.requirement << ": compositional " << above.bound->count() << ", exact "
                           << (below.bound ? below.bound->count() : -1) << " " << name(below.state) << ", "
                           << below.explanation);
    // What fails for want of a bound has a run without a response, or one above the limit.
    if (below.state == Verdict::State::fails) {
      REQUIRE(above.state != Verdict::State::holds);
      const bool lost = below.witness && below.witness->failed;
      REQUIRE_FALSE(lost);
      if (below.witness) REQUIRE(below.witness->measured.value <= above.bound->count());
    }
    if (!below.exact || !below.bound) continue;
    ++tally.compared;
    tally.equal += below.bound == above.bound ? 1 : 0;
    REQUIRE(*below.bound <= *above.bound);
  }
}

void compare_with_runs(const Problem& problem, const Analysis& compositional, std::uint64_t seed) {
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
    const Requirement& requirement = problem.requirements[r];
    const Verdict& verdict = compositional.verdicts[r];
    if (requirement.measure == Requirement::Measure::load || !verdict.bound) continue;
    const Watch watch = watch_of(problem, requirement);
    const Machine machine(problem, watch);
    for (std::uint64_t run = 0; run < 6; ++run) {
      SimulationOptions options;
      options.times = run == 0  ? SimulationOptions::Times::worst
                      : run < 3 ? SimulationOptions::Times::random
                                : SimulationOptions::Times::extremes;
      options.seed = seed * 100 + run;
      options.until = 300 * millisecond;
      options.max_events = 3'000;
      options.record = false;
      const Simulation made = simulate(machine, options);
      INFO(requirement.name << ": compositional " << verdict.bound->count() << ", run " << run);
      REQUIRE_FALSE(made.failed);
      for (const Measurement& measured : made.measured) REQUIRE(measured.value <= verdict.bound->count());
    }
  }
}

template <class Text>
void sandwich(const Text& text_of, std::uint64_t usual_rounds, std::size_t states) {
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", usual_rounds);
  Tally tally;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    const std::string text = text_of(seed);
    const auto skill = test::skill_from_text(text);
    if (!skill->problem) continue;
    INFO("seed " << seed << "\n" << text);
    const Analysis compositional = analyze_compositionally(*skill->problem);
    ++tally.programs;
    for (const Verdict& verdict : compositional.verdicts) {
      if (verdict.measure == Requirement::Measure::load) continue;
      ++tally.requirements;
      tally.bounds += verdict.bound ? 1 : 0;
    }
    compare_with_runs(*skill->problem, compositional, seed);
    compare_with_exact(*skill->problem, compositional, setting("PAL_STATES", states), tally);
  }
  std::cout << tally.programs << " programs with " << tally.requirements << " timed requirements, "
            << tally.bounds << " with a compositional bound; " << tally.compared
            << " bounds compared with exact ones, " << tally.equal << " equal\n";
  CHECK(tally.programs > 0);
}

}  // namespace

TEST_CASE("simulated, exact and compositional come in this order for skills by chance") {
  sandwich([](std::uint64_t seed) { return test::RandomSkill(seed, 9).text(); }, 150, 1'500);
}
