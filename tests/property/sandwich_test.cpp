// What simulation shows <= what exact analysis proves <= what compositional analysis proves, of any program.
#include "tests/property/sandwich.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>
#include <iostream>
#include <sstream>

#include "tests/support/any_skill.hpp"
#include "tests/support/asking_skill.hpp"
#include "tests/support/chain_system.hpp"
#include "tests/support/command_skill.hpp"
#include "tests/support/condition_chain.hpp"
#include "tests/support/held_skill.hpp"
#include "tests/support/mutant.hpp"
#include "tests/support/nested_skill.hpp"
#include "tests/support/odd_skill.hpp"
#include "tests/support/project_file.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/timed_skill.hpp"
#include "tests/support/touch_files.hpp"
#include "tests/support/woven_skill.hpp"

using namespace pal;
using pal::test::compare_by_chance;
using pal::test::setting;
using pal::test::Tally;
using pal::test::usual;

namespace {

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

std::vector<std::string> with_touch_modules(const std::string& skill) {
  std::vector<std::string> files(test::touch_modules.begin(), test::touch_modules.end());
  files.insert(files.end(), {skill, "skills_pal/workcell.pal"});
  return files;
}

/// What mutants are made of: random skills and chains, those of the repository and those that were
/// published.
std::string base(std::uint64_t seed) {
  static const std::vector<std::vector<std::string>> written = {
      with_touch_modules("skills_pal/touch/touch.pal"),
      with_touch_modules("skills_pal/touch/touch_read_first.pal"),
      {"examples/insertion/insertion.pal", "examples/insertion/cell.pal"},
      {"examples/pull_test/pull_test.pal", "examples/pull_test/cell.pal"},
      {"examples/standoff/standoff.pal", "examples/standoff/cell.pal"},
      {"examples/surface_following/surface_following.pal", "examples/surface_following/cell.pal"},
  };
  static const std::vector<std::vector<std::string>> published = files_of("tests/reference/published");
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

/// As any_skill, without saying what is wrong.
std::unique_ptr<test::Skill> any(const std::string& text) {
  return test::any_skill(text);
}

}  // namespace

TEST_CASE("simulated <= exact <= compositional for random skills") {
  compare_by_chance(
      100, 1'000, [](std::uint64_t seed) { return test::RandomSkill(seed, seed % 2 == 0 ? 9 : 40).text(); },
      test::skill_from_text);
}

namespace {

void expect_sandwich_of_periodic_skills(test::Part part) {
  const Tally tally = compare_by_chance(
      400, 300, [](std::uint64_t seed) { return test::TimedSkill(seed).text(); }, test::sound_skill, part);
  if (!usual(400)) return;
  for (const auto& [measure, of] : tally.of) {
    INFO(measure);
    CHECK(of.simulated + of.exact >= 100 / part.of);
  }
}

}  // namespace

TEST_CASE("simulated <= exact <= compositional for periodic skills, part 1 of 3") {
  expect_sandwich_of_periodic_skills({1, 3});
}

TEST_CASE("simulated <= exact <= compositional for periodic skills, part 2 of 3") {
  expect_sandwich_of_periodic_skills({2, 3});
}

TEST_CASE("simulated <= exact <= compositional for periodic skills, part 3 of 3") {
  expect_sandwich_of_periodic_skills({3, 3});
}

namespace {

void expect_sandwich_of_chains(const std::function<test::ChainSystem(std::uint64_t)>& chains,
                               std::uint64_t rounds) {
  Tally tally;
  const std::uint64_t first = setting("PAL_SEED", 1);
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", rounds); ++seed) {
    const test::ChainSystem system = chains(seed);
    INFO("seed " << seed << "\n" << test::text_of(system));
    analyzer::Problem problem = test::problem_of(system);
    // Every measure of some; of the others the exact analysis is asked for the responses alone.
    const bool everything = seed % 4 == 0;
    if (everything) test::require_more(problem);
    test::expect_sandwich(problem, seed, everything ? 150 : 400, tally);
  }
  test::say(tally);
}

}  // namespace

TEST_CASE("simulated <= exact <= compositional for random chains") {
  expect_sandwich_of_chains(test::small_chains, 500);
}

TEST_CASE("simulated <= exact <= compositional for chains with sparse events") {
  expect_sandwich_of_chains(test::drifting_chains, 250);
}

TEST_CASE("simulated <= exact <= compositional for chains by conditions") {
  const Tally tally = compare_by_chance(
      200, 300, [](std::uint64_t seed) { return test::ConditionChain(seed).text(); }, test::sound_skill);
  if (!usual(200)) return;
  for (const auto& [measure, of] : tally.of) {
    INFO(measure);
    CHECK(of.simulated >= 125);
  }
}

TEST_CASE("simulated <= exact <= compositional where sends wait for their slots") {
  const Tally tally = compare_by_chance(
      200, 1'000, [](std::uint64_t seed) { return test::HeldSkill(seed).text(); }, test::sound_skill);
  if (!usual(200)) return;
  for (const auto& [measure, of] : tally.of) {
    INFO(measure);
    CHECK(of.simulated + of.exact >= 75);
  }
}

TEST_CASE("simulated <= exact <= compositional for methods that ask their servers round after round") {
  const Tally tally = compare_by_chance(
      300, 1'000, [](std::uint64_t seed) { return test::AskingSkill(seed).text(); }, any);
  if (!usual(300)) return;
  for (const auto& [measure, of] : tally.of) {
    INFO(measure);
    CHECK(of.simulated + of.exact >= 150);
  }
}

TEST_CASE("simulated <= exact <= compositional for commands to a busy thread") {
  compare_by_chance(
      200, 2'000, [](std::uint64_t seed) { return test::CommandSkill(seed).text(); }, test::skill_from_text);
}

TEST_CASE(
    "simulated, exact and compositional come in this order for modules that ask and serve in many ways") {
  compare_by_chance(
      200, 100, [](std::uint64_t seed) { return test::WovenSkill(seed, seed % 2 == 0).text(); }, any);
}

namespace {

void expect_sandwich_of_odd_skills(test::Part part) {
  std::map<std::string, int> refused;
  compare_by_chance(
      100, 100, [](std::uint64_t seed) { return test::OddSkill(seed, seed % 2 == 1).text(); },
      [&refused](const std::string& text) { return test::any_skill(text, &refused); }, part);
  for (const auto& [why, times] : refused) std::cout << times << " refused: " << why << "\n";
}

}  // namespace

TEST_CASE(
    "simulated, exact and compositional come in this order for modules that take in the middle of a round, "
    "part 1 of 2") {
  expect_sandwich_of_odd_skills({1, 2});
}

TEST_CASE(
    "simulated, exact and compositional come in this order for modules that take in the middle of a round, "
    "part 2 of 2") {
  expect_sandwich_of_odd_skills({2, 2});
}

TEST_CASE("simulated <= exact <= compositional for blocks within blocks") {
  Tally tally;
  std::map<std::string, int> refused;
  const std::uint64_t first = setting("PAL_SEED", 1);
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 75); ++seed) {
    const std::string text = test::NestedSkill(seed).text();
    const auto skill = test::any_skill(text, &refused);
    if (!skill->problem) continue;
    INFO("seed " << seed << "\n" << text);
    expect_sandwich(*skill->problem, seed, 100, tally);
  }
  for (const auto& [why, times] : refused) std::cout << times << " refused: " << why << "\n";
  say(tally);
}

TEST_CASE("simulated <= exact <= compositional for skills with mistakes") {
  compare_by_chance(
      100, 300,
      [](std::uint64_t seed) {
        const auto sound = [](const std::string& text) {
          return test::skill_from_text(text)->problem.has_value();
        };
        return test::Mutant(seed, base(seed), sound).text(1 + static_cast<int>(seed % 5));
      },
      test::sound_skill);
}
