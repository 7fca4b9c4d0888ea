// Skills in which much takes no time, and much happens at one instant, against runs that are made without the
// analyzer.
#include <catch2/catch.hpp>
#include <iostream>
#include <random>

#include "analyzer/exact/exact.hpp"
#include "tests/attack/contradiction.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/many_parties.hpp"
#include "tests/support/random_cell.hpp"
#include "tests/support/runs/all_runs.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/stopped_blocks.hpp"
#include "tests/support/timed_skill.hpp"
#include "tests/support/wider.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;

namespace {

constexpr Duration millisecond{1'000'000};
constexpr int cap = 100;

struct Tally {
  std::size_t skills = 0;
  std::size_t exact = 0;
  std::size_t complete = 0;
};

/// All its times are whole milliseconds.
std::string text_of(std::uint64_t seed) {
  switch (seed % 8) {
    case 0:
      return test::StoppedBlocks(seed).text();
    case 1:
      return test::ManyParties(seed).text();
    case 2:
      return test::TimedSkill(seed).text();
    default:
      return test::RandomCell(seed, 3, static_cast<int>(seed % 3), test::RandomCell::Asks::all).text();
  }
}

std::string contradiction(test::AllRuns& runs, const test::Wanted& wanted, const Verdict& verdict,
                          std::uint64_t seed, Tally& tally) {
  const std::uint64_t states = setting("PAL_STATES", 10'000);
  const test::Seen seen = runs.enumerate(verdict.exact ? states : 0);
  tally.exact += verdict.exact ? 1 : 0;
  tally.complete += seen.complete ? 1 : 0;
  std::string wrong = test::contradiction(wanted, seen, verdict, millisecond, cap);
  if (!wrong.empty()) {
    runs.tell = true;
    runs.enumerate(states);
    return wrong;
  }
  if (seen.complete || wanted.kind == test::Wanted::Kind::load) return {};
  for (std::uint64_t walk = 0; walk < setting("PAL_WALKS", 20); ++walk) {
    test::Lottery lottery(seed * 1000 + walk);
    wrong = test::contradiction(wanted, runs.walk(lottery, 1000), verdict, millisecond, cap);
    if (wrong.empty()) continue;
    test::Lottery again(seed * 1000 + walk);
    runs.tell = true;
    runs.walk(again, 1000);
    return wrong;
  }
  return {};
}

void attack(std::uint64_t seed, Tally& tally) {
  const std::string text = text_of(seed);
  const auto skill = test::any_skill(text);
  if (!skill->problem) return;
  std::mt19937_64 engine(seed);
  pan::Network& network = skill->specification.skills.front();
  pan::Environment& environment = skill->specification.environments.front();
  const std::string how = test::other_times(network, environment, engine);
  Diagnostics diagnostics;
  const auto problem = make_problem(network, environment, diagnostics);
  if (!problem) return;
  ++tally.skills;
  Options options;
  options.max_states = setting("PAL_CLASSES", 3'000);
  const Analysis analysis = analyze(*problem, options);
  for (const test::Wanted& wanted : test::wanted(network, environment)) {
    const auto found = std::find_if(analysis.verdicts.begin(), analysis.verdicts.end(),
                                    [&](const Verdict& each) { return each.requirement == wanted.name; });
    REQUIRE(found != analysis.verdicts.end());
    test::AllRuns runs(network, environment, wanted, millisecond, cap);
    const std::string wrong = contradiction(runs, wanted, *found, seed, tally);
    std::string story;
    for (const std::string& line : runs.story) story += line + "\n";
    INFO("seed " << seed << " with " << how << " " << wanted.name << ": " << name(found->state) << ", "
                 << found->explanation << "\n"
                 << text << story);
    CHECK(wrong == "");
  }
}

}  // namespace

TEST_CASE("no run in which much takes no time exceeds what was proved") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  Tally tally;
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 24); ++seed) attack(seed, tally);
  std::cout << tally.skills << " skills, " << tally.exact << " exact verdicts, all runs seen of "
            << tally.complete << "\n";
  CHECK(tally.complete > 0);
}
