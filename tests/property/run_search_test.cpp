// Runs that are looked for: facts, never beyond what is proved, and mostly the worst there are.
#include <catch2/catch.hpp>
#include <iostream>

#include "analyzer/analysis.hpp"
#include "analyzer/runs/run_search.hpp"
#include "analyzer/runs/zone_walk.hpp"
#include "tests/support/chain_system.hpp"
#include "tests/support/confirm.hpp"
#include "tests/support/random_skill.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;

namespace {

struct Tally {
  std::size_t found = 0;
  std::size_t exact = 0;
  std::size_t worst = 0;  // the run is the worst there is
};

void expect_found(const Problem& problem, std::size_t r, const Verdict& exact, Tally& tally) {
  const Requirement& requirement = problem.requirements[r];
  RunSearchOptions how;
  how.runs = 60;
  const auto found = search_runs(problem, requirement, how);
  if (!found) return;
  ++tally.found;
  INFO(requirement.name << ": found " << found->measured.value << ", failed " << found->failed << "; "
                        << name(exact.state) << " " << (exact.bound ? exact.bound->count() : -1) << ", "
                        << exact.explanation.text());
  REQUIRE(test::refusal(problem, requirement, *found, found->trace) == "");
  REQUIRE(exact.state != Verdict::State::never);
  if (found->failed) REQUIRE(exact.state != Verdict::State::holds);
  if (found->failed || !exact.bound) return;
  const Nanoseconds bound = exact.bound->count();
  if (requirement.at_least) {
    REQUIRE(found->measured.value >= bound);
  } else {
    REQUIRE(found->measured.value <= bound);
  }
  tally.exact += exact.exact ? 1 : 0;
  tally.worst += exact.exact && found->measured.value == bound ? 1 : 0;
}

void expect_all(const Problem& problem, Tally& tally) {
  Options options;
  options.max_states = 2'000;
  const Analysis exact = analyze_exactly(problem, options);
  for (std::size_t r = 0; r < problem.requirements.size(); ++r)
    expect_found(problem, r, exact.verdicts[r], tally);
}

}  // namespace

TEST_CASE("runs found by the search are runs of the skill, within the bounds") {
  Tally tally;
  const std::uint64_t first = setting("PAL_SEED", 1);
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 30); ++seed) {
    const std::string text = test::RandomSkill(seed, seed % 2 == 0 ? 9 : 40).text();
    const auto skill = test::skill_from_text(text);
    if (!skill->problem) continue;
    INFO("seed " << seed << "\n" << text);
    expect_all(*skill->problem, tally);
  }
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 30); ++seed) {
    const test::ChainSystem system = test::small_chains(seed);
    INFO("seed " << seed << "\n" << test::text_of(system));
    expect_all(test::problem_of(system), tally);
  }
  std::cout << tally.found << " runs found; of " << tally.exact << " with an exact bound " << tally.worst
            << " attain it\n";
  CHECK(tally.found > 0);
  CHECK(10 * tally.worst > 7 * tally.exact);
}

TEST_CASE("runs found by walks through zones are runs of the skill, within the bounds") {
  std::size_t found = 0;
  std::size_t tried = 0;
  const std::uint64_t first = setting("PAL_SEED", 1);
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 30); ++seed) {
    const std::string text = test::RandomSkill(seed, seed % 2 == 0 ? 9 : 40).text();
    const auto skill = test::skill_from_text(text);
    if (!skill->problem) continue;
    Options options;
    options.max_states = 2'000;
    const Analysis exact = analyze_exactly(*skill->problem, options);
    for (std::size_t r = 0; r < exact.verdicts.size(); ++r) {
      Requirement requirement = skill->problem->requirements[r];
      const Verdict& verdict = exact.verdicts[r];
      if (!verdict.bound || requirement.measure == Requirement::Measure::load) continue;
      // Not quite the worst there is.
      const Nanoseconds bound = verdict.bound->count();
      requirement.limit = requirement.at_least ? bound + bound / 8 + 1 : bound - bound / 8 - 1;
      ZoneWalkOptions how;
      how.steps = 3'000;
      const auto walked = walk_zones(*skill->problem, requirement, how);
      INFO("seed " << seed << ", " << requirement.name << ", bound " << bound << "\n" << text);
      if (verdict.exact && verdict.witness && !verdict.witness->failed) ++tried;
      if (!walked) continue;
      ++found;
      REQUIRE(test::refusal(*skill->problem, requirement, *walked, walked->trace) == "");
      if (walked->failed) {
        REQUIRE(verdict.state != Verdict::State::holds);
        continue;
      }
      const Nanoseconds value = walked->measured.value;
      REQUIRE((requirement.at_least ? value < requirement.limit : value > requirement.limit));
      REQUIRE((requirement.at_least ? value >= bound : value <= bound));
    }
  }
  std::cout << found << " runs found by walks, of " << tried << " that there are\n";
  CHECK(4 * found > 3 * tried);
}

TEST_CASE("a large system: a run refutes a requirement whose bound is above the limit") {
  test::ChainShape shape;
  shape.processors = 3;
  shape.chains = 6;
  shape.load = 0.7;
  Problem problem = test::problem_of(test::random_chains(3, shape));
  Options few;
  few.max_states = 200;
  const Analysis before = analyze(problem, AnalysisChoice::thorough, few);
  std::size_t refuted = 0;
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
    const Verdict& verdict = before.verdicts[r];
    if (!verdict.witness || verdict.exact) continue;
    REQUIRE(verdict.state != Verdict::State::fails);
    problem.requirements[r].limit = verdict.witness->measured.value - 1;
  }
  const Analysis after = analyze(problem, AnalysisChoice::thorough, few);
  REQUIRE(test::unconfirmed(problem, after) == "");
  for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
    const Verdict& verdict = after.verdicts[r];
    CHECK(test::unexplained(verdict) == "");
    if (verdict.state != Verdict::State::fails) continue;
    ++refuted;
    REQUIRE(verdict.witness);
    CHECK((verdict.witness->failed || verdict.witness->measured.value > verdict.limit.count()));
  }
  CHECK(refuted > 0);
}

// Each round is the last one with a probability of a half, and a value ages round by round.
TEST_CASE("steady runs go round a loop for long") {
  const auto skill = test::sound_skill(R"(
MESSAGE tick : SIGNAL

CONDITION old
CONDITION done

SKILL round
  MACHINE CONTROLLER Clock
  SKILL METHOD       SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT young : AGE OF old AT act AT MOST 300 ms
END SKILL

Machine Controller: Clock

Skill Module: SM1
  ACTIVITY act
BEGIN
  WTM( Coordinator )
  SPC( old )
  REPEAT
    WTM( tick from Clock )
    RPC( old )
    act
    SPC( done )
  UNTIL( done )
  TXM( Completion Protocol 0 )
END

ENVIRONMENT cell
  PROCESSOR P
  PLACE SM1 ON P PRIORITY 1
  TIME act : 1 ms
  DEVICE Clock EVENT tick EVERY 10 ms
END ENVIRONMENT
)");
  const Requirement& requirement = skill->problem->requirements.front();
  RunSearchOptions how;
  const auto usual = search_runs(*skill->problem, requirement, how);
  REQUIRE(usual);
  CHECK(usual->measured.value < requirement.limit);
  how.steady = 64;
  const auto steady = search_runs(*skill->problem, requirement, how);
  REQUIRE(steady);
  CHECK(steady->measured.value > requirement.limit);
  CHECK(test::refusal(*skill->problem, requirement, *steady, steady->trace) == "");
}

TEST_CASE("a run is found in which a skill completes after many events") {
  // Each activity takes 1 ms.
  constexpr int activities = 1'500;
  std::string text = R"(
SKILL long
  SKILL METHOD SM1
  COMPLETION 0 NORMAL
  COMPLETION 1 ERROR
  REQUIREMENT span : DURATION TO COMPLETION 0 AT MOST 2 s
END SKILL
Skill Module: SM1
  ACTIVITY work
BEGIN
  WTM( Coordinator )
)";
  for (int n = 0; n < activities; ++n) text += "  work\n";
  text += R"(
  TXM( Completion Protocol 0 )
END
ENVIRONMENT cell
  PROCESSOR P0
  PLACE SM1 ON P0 PRIORITY 1
  TIME work : 1 ms
END ENVIRONMENT
)";
  const auto skill = test::sound_skill(text);
  const auto found = search_runs(*skill->problem, skill->problem->requirements[0], {});
  REQUIRE(found);
  CHECK(found->measured.value == activities * 1'000'000);
}
