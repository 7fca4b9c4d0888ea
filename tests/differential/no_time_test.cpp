// Skills in which much takes no time, and much happens at one instant, against runs that are made without the
// analyzer.
#include <catch2/catch.hpp>
#include <iostream>
#include <random>

#include "analyzer/exact/exact.hpp"
#include "tests/differential/contradiction.hpp"
#include "tests/support/kinds.hpp"
#include "tests/support/many_parties.hpp"
#include "tests/support/random_cell.hpp"
#include "tests/support/runs/all_runs.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/stopped_blocks.hpp"
#include "tests/support/wider.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;

namespace {

constexpr Duration one_millisecond{1'000'000};
constexpr Duration longest_run = 100 * one_millisecond;

struct NoTimeTally {
  std::size_t skills = 0;
  std::size_t exact = 0;
  std::size_t complete = 0;
};

/// One that is small, or of any kind.
std::string text_of(std::uint64_t seed, bool small) {
  if (!small) return test::skill_of_any_kind(seed);
  if (seed % 8 == 0) return test::StoppedBlocks(seed).text();
  if (seed % 8 == 1) return test::ManyParties(seed).text();
  return test::RandomCell(seed, 3, static_cast<int>(seed / 8 % 3), test::RandomCell::Asks::all).text();
}

std::string contradiction(test::AllRuns& runs, const test::Wanted& wanted, const Verdict& verdict,
                          Duration unit, std::uint64_t seed, bool small, NoTimeTally& tally) {
  const int cap = static_cast<int>(longest_run / unit);
  const std::uint64_t states = small && verdict.exact ? setting("PAL_STATES", 10'000) : 0;
  const test::Seen seen = runs.enumerate(states);
  tally.exact += verdict.exact ? 1 : 0;
  tally.complete += seen.complete ? 1 : 0;
  std::string wrong = test::contradiction(wanted, seen, verdict, unit, cap);
  if (!wrong.empty()) {
    runs.tell = true;
    runs.enumerate(states);
    return wrong;
  }
  if (seen.complete || wanted.kind == test::Wanted::Kind::load) return {};
  for (std::uint64_t walk = 0; walk < setting("PAL_WALKS", 20); ++walk) {
    test::BiasedDecisions decisions(seed * 1000 + walk);
    wrong = test::contradiction(wanted, runs.walk(decisions, 1000), verdict, unit, cap);
    if (wrong.empty()) continue;
    test::BiasedDecisions again(seed * 1000 + walk);
    runs.tell = true;
    runs.walk(again, 1000);
    return wrong;
  }
  return {};
}

void expect_sound(std::uint64_t seed, NoTimeTally& tally) {
  const bool small = seed % 4 != 3;
  const std::string text = text_of(seed, small);
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
  const Analysis analysis = analyze_exactly(*problem, options);
  const Duration unit = test::grain(network, environment);
  if (unit < one_millisecond / 1000) return;
  for (const test::Wanted& wanted : test::wanted(network, environment)) {
    const auto found = std::find_if(analysis.verdicts.begin(), analysis.verdicts.end(),
                                    [&](const Verdict& each) { return each.requirement == wanted.name; });
    REQUIRE(found != analysis.verdicts.end());
    test::AllRuns runs(network, environment, wanted, unit, static_cast<int>(longest_run / unit));
    const std::string wrong = contradiction(runs, wanted, *found, unit, seed, small, tally);
    std::string story;
    for (const std::string& line : runs.story) story += line + "\n";
    INFO("seed " << seed << " with " << how << " " << wanted.name << ": " << name(found->state) << ", "
                 << found->explanation.text() << "\n"
                 << text << story);
    CHECK(wrong == "");
  }
}

}  // namespace

TEST_CASE("no run with many actions in no time exceeds a bound") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  NoTimeTally tally;
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 12); ++seed)
    expect_sound(seed, tally);
  std::cout << tally.skills << " skills, " << tally.exact << " exact verdicts, all runs seen of "
            << tally.complete << "\n";
  CHECK(tally.complete > 0);
}
