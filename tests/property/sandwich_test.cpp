// What simulation shows <= what exact analysis proves <= what compositional analysis proves, of any program.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>

#include "analyzer/analysis.hpp"
#include "analyzer/compositional/compositional.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/chain_system.hpp"
#include "tests/support/command_skill.hpp"
#include "tests/support/condition_chain.hpp"
#include "tests/support/held_skill.hpp"
#include "tests/support/holistic.hpp"
#include "tests/support/mutant.hpp"
#include "tests/support/nested_skill.hpp"
#include "tests/support/odd_skill.hpp"
#include "tests/support/project_file.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/skill.hpp"
#include "tests/support/timed_skill.hpp"
#include "tests/support/woven_skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;

namespace {

constexpr Nanoseconds millisecond = 1'000'000;

/// What was compared, by measure.
struct Tally {
  struct Of {
    std::size_t requirements = 0;
    std::size_t bounds = 0;     // compositional ones
    std::size_t simulated = 0;  // bounds that some run has a value for
    std::size_t exact = 0;      // bounds compared with exact ones
    std::size_t equal = 0;
  };
  std::size_t programs = 0;
  std::map<std::string, Of> of;
};

std::string measure_of(const Requirement& requirement) {
  std::string measure = name(requirement.measure);
  const bool known = requirement.measure == Requirement::Measure::age ||
                     requirement.measure == Requirement::Measure::reaction;
  if (known) measure += requirement.condition < 0 ? " of a sample" : " of a condition";
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
  const Analysis exact = analyze(problem, options);
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
    const Verdict& above = compositional.verdicts[r];
    const Verdict& below = exact.verdicts[r];
    if (!above.bound) continue;
    const bool kept = above.at_least ? *above.bound >= above.limit : *above.bound <= above.limit;
    REQUIRE((above.state == Verdict::State::holds) == kept);
    INFO(above.requirement << ": compositional " << above.bound->count() << ", exact "
                           << (below.bound ? below.bound->count() : -1) << " " << name(below.state) << ", "
                           << below.explanation);
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
void check_arithmetic(const Analysis& analysis) {
  for (const Verdict& verdict : analysis.verdicts) {
    if (!verdict.bound || verdict.addends.empty()) continue;
    Nanoseconds sum = 0;
    for (const Addend& each : verdict.addends) sum += each.amount;
    INFO(verdict.requirement);
    REQUIRE(sum == verdict.bound->count());
  }
}

void compare(const Problem& problem, std::uint64_t seed, std::size_t states, Tally& tally) {
  const Analysis compositional = analyze_compositionally(problem);
  check_arithmetic(compositional);
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

/// Of all files in a folder with one skill and its environment each, the names in order.
std::vector<std::vector<std::string>> files_of(const std::string& folder) {
  std::vector<std::vector<std::string>> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(PAL_SOURCE_DIR) + "/" + folder)) {
    if (entry.path().extension() == ".pal")
      files.push_back({folder + "/" + entry.path().filename().string()});
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// What mutants are made of: skills and chains by chance, those of the repository and those that were
/// published.
std::string base(std::uint64_t seed) {
  static const std::vector<std::vector<std::string>> written = {
      {"skills_pal/touch/touch_modules.pal", "skills_pal/touch/touch.pal", "skills_pal/workcell.pal"},
      {"skills_pal/touch/touch_modules.pal", "skills_pal/touch/touch_read_first.pal",
       "skills_pal/workcell.pal"},
      {"examples/insertion/insertion.pal", "examples/insertion/cell.pal"},
      {"examples/pull_test/pull_test.pal", "examples/pull_test/cell.pal"},
      {"examples/standoff/standoff.pal", "examples/standoff/cell.pal"},
      {"examples/surface_following/surface_following.pal", "examples/surface_following/cell.pal"},
  };
  static const std::vector<std::vector<std::string>> published = files_of("tests/figures/published");
  if (seed % 3 == 1) return test::TimedSkill(seed).text();
  if (seed % 6 == 2) return test::text_of(test::small_chains(seed));
  const auto& from = seed % 6 == 5 ? published : written;
  std::string text;
  for (const std::string& path : from[seed / 6 % from.size()]) {
    std::istringstream file(test::project_file(path));
    for (std::string line; std::getline(file, line);)
      if (line.find("USES") == std::string::npos) text += line + "\n";
  }
  return text;
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

}  // namespace

TEST_CASE("simulated, exact and compositional come in this order for skills by chance") {
  Tally tally;
  const std::uint64_t first = setting("PAL_SEED", 1);
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 100); ++seed) {
    const std::string text = test::RandomSkill(seed, seed % 2 == 0 ? 9 : 40).text();
    const auto skill = test::skill_from_text(text);
    if (!skill->problem) continue;
    INFO("seed " << seed << "\n" << text);
    compare(*skill->problem, seed, 1'000, tally);
  }
  say(tally);
}

TEST_CASE("simulated, exact and compositional come in this order for skills that keep pace") {
  Tally tally;
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 800);
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    const std::string text = test::TimedSkill(seed).text();
    const auto skill = test::sound_skill(text);
    INFO("seed " << seed << "\n" << text);
    compare(*skill->problem, seed, 300, tally);
  }
  say(tally);
  if (first != 1 || rounds != 800) return;
  for (const auto& [measure, of] : tally.of) {
    INFO(measure);
    CHECK(of.simulated + of.exact >= 200);
  }
}

TEST_CASE("simulated, exact and compositional come in this order for chains by chance") {
  Tally tally;
  const std::uint64_t first = setting("PAL_SEED", 1);
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 1'000); ++seed) {
    const test::ChainSystem system = test::small_chains(seed);
    INFO("seed " << seed << "\n" << test::text_of(system));
    Problem problem = test::problem_of(system);
    // Every measure of some; of the others the exact analysis is asked for the responses alone.
    const bool everything = seed % 4 == 0;
    if (everything) test::require_more(problem);
    compare(problem, seed, everything ? 150 : 400, tally);
  }
  say(tally);
}

TEST_CASE("simulated, exact and compositional come in this order for chains by conditions") {
  Tally tally;
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 400);
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    const std::string text = test::ConditionChain(seed).text();
    const auto skill = test::sound_skill(text);
    INFO("seed " << seed << "\n" << text);
    compare(*skill->problem, seed, 300, tally);
  }
  say(tally);
  if (first != 1 || rounds != 400) return;
  for (const auto& [measure, of] : tally.of) {
    INFO(measure);
    CHECK(of.simulated >= 250);
  }
}

TEST_CASE("simulated, exact and compositional come in this order where sends wait for their slots") {
  Tally tally;
  const std::uint64_t first = setting("PAL_SEED", 1);
  const std::uint64_t rounds = setting("PAL_ROUNDS", 400);
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    const std::string text = test::HeldSkill(seed).text();
    const auto skill = test::sound_skill(text);
    INFO("seed " << seed << "\n" << text);
    compare(*skill->problem, seed, 1'000, tally);
  }
  say(tally);
  if (first != 1 || rounds != 400) return;
  for (const auto& [measure, of] : tally.of) {
    INFO(measure);
    CHECK(of.simulated + of.exact >= 150);
  }
}

TEST_CASE("simulated, exact and compositional come in this order for commands to a thread at work") {
  Tally tally;
  const std::uint64_t first = setting("PAL_SEED", 1);
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 200); ++seed) {
    const std::string text = test::CommandSkill(seed).text();
    const auto skill = test::skill_from_text(text);
    if (!skill->problem) continue;
    INFO("seed " << seed << "\n" << text);
    compare(*skill->problem, seed, 2'000, tally);
  }
  say(tally);
}

TEST_CASE(
    "simulated, exact and compositional come in this order for modules that ask and serve in many ways") {
  Tally tally;
  const std::uint64_t first = setting("PAL_SEED", 1);
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 400); ++seed) {
    const std::string text = test::WovenSkill(seed, seed % 2 == 0).text();
    const auto skill = test::any_skill(text);
    if (!skill->problem) continue;
    INFO("seed " << seed << "\n" << text);
    compare(*skill->problem, seed, 100, tally);
  }
  say(tally);
}

TEST_CASE(
    "simulated, exact and compositional come in this order for modules that take in the middle of a round") {
  Tally tally;
  std::map<std::string, int> refused;
  const std::uint64_t first = setting("PAL_SEED", 1);
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 200); ++seed) {
    const std::string text = test::OddSkill(seed, seed % 2 == 1).text();
    const auto skill = test::any_skill(text, &refused);
    if (!skill->problem) continue;
    INFO("seed " << seed << "\n" << text);
    compare(*skill->problem, seed, 100, tally);
  }
  for (const auto& [why, times] : refused) std::cout << times << " refused: " << why << "\n";
  say(tally);
}

TEST_CASE("simulated, exact and compositional come in this order for blocks within blocks") {
  Tally tally;
  std::map<std::string, int> refused;
  const std::uint64_t first = setting("PAL_SEED", 1);
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 200); ++seed) {
    const std::string text = test::NestedSkill(seed).text();
    const auto skill = test::any_skill(text, &refused);
    if (!skill->problem) continue;
    INFO("seed " << seed << "\n" << text);
    compare(*skill->problem, seed, 100, tally);
  }
  for (const auto& [why, times] : refused) std::cout << times << " refused: " << why << "\n";
  say(tally);
}

TEST_CASE("simulated, exact and compositional come in this order for skills with mistakes in them") {
  Tally tally;
  const std::uint64_t first = setting("PAL_SEED", 1);
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 200); ++seed) {
    const auto sound = [](const std::string& text) {
      return test::skill_from_text(text)->problem.has_value();
    };
    const std::string text = test::Mutant(seed, base(seed), sound).text(1 + static_cast<int>(seed % 5));
    const auto skill = test::sound_skill(text);
    INFO("seed " << seed << "\n" << text);
    compare(*skill->problem, seed, 300, tally);
  }
  say(tally);
}

TEST_CASE("what once broke the order") {
  Tally tally;
  // A wait at the start that gives up opens a device before the wait that is its taker's home. A request that
  // is withdrawn before its server takes it brings no round about. While a CONCURRENT waits for one of its
  // blocks, statements of another that is over come no more.
  for (const auto& [seed, longest] : {std::pair{123801U, 40}, {30010203U, 40}, {30033352U, 9}}) {
    const auto skill = test::skill_from_text(test::RandomSkill(seed, longest).text());
    REQUIRE(skill->problem);
    compare(*skill->problem, seed, 300, tally);
  }
}

TEST_CASE("a loop in no time is looked for in a part of the classes") {
  // Some edges of that part lead to classes that others have replaced.
  const auto skill = test::any_skill(test::WovenSkill(5014).text());
  REQUIRE(skill->problem);
  Options options;
  options.max_states = 300;
  options.threads = 1;
  CHECK(analyze(*skill->problem, AnalysisChoice::automatic, options).verdicts.size() ==
        skill->problem->requirements.size());
}

TEST_CASE("an answer that is sent twice is there before it is asked for") {
  // LS1's second answer is SD1's spare one: it does not take the sensor's 2 ms.
  const auto skill = test::sound_skill(R"(MESSAGE force : REAL N
MESSAGE raw : REAL N
DEVICE sensor
SKILL twice
  SENSOR DRIVER SD1
  LOGICAL SENSOR LS1
  MACHINE CONTROLLER NONE
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT apart : INTERVAL OF think IN SM1 AT LEAST 1 ms
END SKILL
Sensor Driver: SD1
BEGIN
  REPEAT
    WTM( request raw from LS1 )
    TXM( request raw from sensor )
    WTM( raw from sensor )
    TXM( raw to LS1 )
    TXM( raw to LS1 )
  UNTIL( forever )
END
Logical Sensor: LS1
BEGIN
  REPEAT
    WTM( request force from SM1 )
    TXM( request raw from SD1 )
    WTM( raw from SD1 )
    TXM( force to SM1 )
  UNTIL( forever )
END
Skill Module: SM1
  ACTIVITY think
BEGIN
  WTM( Coordinator )
  TXM( request force from LS1 )
  WTM( force from LS1 )
  think
  TXM( request force from LS1 )
  WTM( force from LS1 )
  think
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P0
  DEVICE sensor ON REQUEST 2 ms
  PLACE SM1 ON P0 PRIORITY 1
  PLACE LS1 ON P0 PRIORITY 1
  PLACE SD1 ON P0 PRIORITY 1
  TIME think : 1 ms
END ENVIRONMENT
)");
  const Analysis above = analyze_compositionally(*skill->problem);
  const Analysis exact = analyze(*skill->problem);
  REQUIRE(exact.verdicts.front().exact);
  CHECK(exact.verdicts.front().bound == Duration(millisecond));
  REQUIRE(above.verdicts.front().bound);
  CHECK(*above.verdicts.front().bound <= *exact.verdicts.front().bound);
}

TEST_CASE("a system of chains has the same bounds built directly and read from PAL") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const test::ChainSystem system = test::small_chains(seed);
    INFO("seed " << seed << "\n" << test::text_of(system));
    const auto skill = test::sound_skill(test::text_of(system));
    const Analysis read = analyze_compositionally(*skill->problem);
    const Analysis built = analyze_compositionally(test::problem_of(system));
    REQUIRE(read.verdicts.size() == built.verdicts.size());
    for (std::size_t r = 0; r < read.verdicts.size(); ++r)
      CHECK(read.verdicts[r].bound == built.verdicts[r].bound);
  }
}

TEST_CASE("bounds of chains are at or under those of the holistic analysis") {
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    const test::ChainSystem system = test::random_chains(seed, test::benchmark_shape(seed));
    const auto holistic = test::holistic(system);
    const Analysis analysis = analyze_compositionally(test::problem_of(system));
    for (std::size_t c = 0; c < holistic.size(); ++c) {
      INFO("seed " << seed << " chain " << c + 1);
      if (analysis.verdicts[c].bound && holistic[c])
        CHECK(analysis.verdicts[c].bound->count() <= *holistic[c]);
    }
  }
}
