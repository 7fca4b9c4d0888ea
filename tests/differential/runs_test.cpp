// The analyzer against runs that are made without it: straight from docs/reference/execution-model.md
// (tests/support/runs/all_runs.hpp).
#include <catch2/catch.hpp>
#include <cstdlib>
#include <functional>
#include <iostream>

#include "analyzer/exact/exact.hpp"
#include "tests/differential/contradiction.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/many_parties.hpp"
#include "tests/support/mutant.hpp"
#include "tests/support/random_cell.hpp"
#include "tests/support/runs/all_runs.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/silent_devices.hpp"
#include "tests/support/stopped_blocks.hpp"
#include "tests/support/timed_skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;

namespace {

constexpr Duration millisecond{1'000'000};

struct Counts {
  std::size_t timed = 0;
  std::size_t bounded = 0;
  std::size_t exact = 0;
  std::size_t complete = 0;
  std::size_t equal = 0;
};

constexpr int most_states = 100;

/// What was compared, by measure, of how many skills; and why others were refused.
struct RunTally {
  std::map<std::string, int> refused;
  std::size_t skills = 0;
  std::map<std::string, Counts> of;
};

/// All runs if there are few, else single random ones, against a verdict. What contradicts it, or nothing.
std::string contradiction(test::AllRuns& runs, const test::Wanted& wanted, const Verdict& verdict,
                          std::uint64_t seed, Counts& counts) {
  const std::uint64_t states = setting("PAL_STATES", 20'000);
  const bool load = wanted.kind == test::Wanted::Kind::load;
  const test::Seen seen = runs.enumerate(verdict.exact || load ? states : 0);
  std::string wrong = test::contradiction(wanted, seen, verdict, millisecond, most_states);
  counts.complete += seen.complete ? 1 : 0;
  counts.equal += seen.complete && verdict.exact ? 1 : 0;
  if (!wrong.empty()) {
    runs.tell = true;
    runs.enumerate(states);
    return wrong + (seen.complete ? " (complete)" : "");
  }
  const std::uint64_t walks = seen.complete || load ? 0 : setting("PAL_WALKS", 40);
  for (std::uint64_t walk = 0; walk < walks; ++walk) {
    test::RandomDecisions decisions(seed * 1000 + walk);
    test::Seen one = runs.walk(decisions, 1500);
    one.complete = false;
    wrong = test::contradiction(wanted, one, verdict, millisecond, most_states);
    if (wrong.empty()) continue;
    test::RandomDecisions again(seed * 1000 + walk);
    runs.tell = true;
    runs.walk(again, 1500);
    return wrong;
  }
  return {};
}

/// The verdicts on each thing that the skill is required to keep. All its times are whole milliseconds.
void expect_sound(const std::string& text, std::uint64_t seed, RunTally& tally) {
  const auto skill = test::any_skill(text, &tally.refused);
  if (!skill->problem) return;
  ++tally.skills;
  const pan::Network& network = skill->specification.skills.front();
  const pan::Environment& environment = skill->specification.environments.front();
  Options options;
  options.max_states = setting("PAL_CLASSES", 4'000);
  const Analysis analysis = analyze_exactly(*skill->problem, options);
  for (const test::Wanted& wanted : test::wanted(network, environment)) {
    const auto found = std::find_if(analysis.verdicts.begin(), analysis.verdicts.end(),
                                    [&](const Verdict& each) { return each.requirement == wanted.name; });
    REQUIRE(found != analysis.verdicts.end());
    const Verdict& verdict = *found;
    Counts& counts = tally.of[name(verdict.measure)];
    ++counts.timed;
    counts.bounded += verdict.bound ? 1 : 0;
    counts.exact += verdict.exact ? 1 : 0;
    test::AllRuns runs(network, environment, wanted, millisecond, most_states);
    const std::string wrong = contradiction(runs, wanted, verdict, seed, counts);
    std::string story;
    for (const std::string& line : runs.story) story += line + "\n";
    INFO("seed " << seed << " " << wanted.name << ": " << name(verdict.state) << ", "
                 << verdict.explanation.text() << "\n"
                 << text << story);
    CHECK(wrong == "");
  }
}

void say(const RunTally& tally) {
  std::cout << tally.skills << " skills\n";
  for (const auto& [measure, counts] : tally.of)
    std::cout << measure << ": " << counts.timed << " requirements, " << counts.bounded << " bounded, "
              << counts.exact << " exact, all runs seen of " << counts.complete << ", compared "
              << counts.equal << "\n";
  if (std::getenv("PAL_REFUSED") != nullptr)
    for (const auto& [what, count] : tally.refused) std::cout << count << " " << what << "\n";
  CHECK(tally.skills > 0);
}

/// For `rounds` skills, if no other number is set, or for a part of them.
void expect_all_sound(std::uint64_t rounds, const std::function<std::string(std::uint64_t)>& text,
                      test::Part part = {}) {
  RunTally tally;
  for (const std::uint64_t seed : test::seeds(1, rounds, part)) expect_sound(text(seed), seed, tally);
  say(tally);
}

std::string cell(std::uint64_t seed, int longest) {
  return test::RandomCell(seed, longest, static_cast<int>(seed % 3), test::RandomCell::Asks::all).text();
}

void expect_sound_cells(test::Part part) {
  const int longest = static_cast<int>(setting("PAL_LONGEST", 4));
  expect_all_sound(
      30, [longest](std::uint64_t seed) { return cell(seed, longest); }, part);
}

void expect_sound_with_mistakes(test::Part part) {
  const auto with_mistakes = [](std::uint64_t seed) {
    const auto accepts = [](const std::string& text) { return test::any_skill(text)->problem.has_value(); };
    const std::string right = seed % 2 == 0 ? test::TimedSkill(seed).text() : cell(seed, 4);
    return test::Mutant(seed, right, accepts).text(1 + static_cast<int>(seed % 5));
  };
  expect_all_sound(20, with_mistakes, part);
}

}  // namespace

TEST_CASE("no run that follows the execution model exceeds a bound, part 1 of 2") {
  expect_sound_cells({1, 2});
}

TEST_CASE("no run that follows the execution model exceeds a bound, part 2 of 2") {
  expect_sound_cells({2, 2});
}

TEST_CASE("no run of a skill with mistakes exceeds a bound, part 1 of 3") {
  expect_sound_with_mistakes({1, 3});
}

TEST_CASE("no run of a skill with mistakes exceeds a bound, part 2 of 3") {
  expect_sound_with_mistakes({2, 3});
}

TEST_CASE("no run of a skill with mistakes exceeds a bound, part 3 of 3") {
  expect_sound_with_mistakes({3, 3});
}

TEST_CASE("no run in which devices do not answer exceeds a bound") {
  expect_all_sound(20, [](std::uint64_t seed) { return test::with_silent_devices(cell(seed, 4)); });
}

TEST_CASE("no run in which blocks are stopped exceeds a bound") {
  expect_all_sound(75, [](std::uint64_t seed) { return test::StoppedBlocks(seed).text(); });
}

TEST_CASE("no run in which many threads share one message exceeds a bound") {
  expect_all_sound(15, [](std::uint64_t seed) { return test::ManyParties(seed).text(); });
}
