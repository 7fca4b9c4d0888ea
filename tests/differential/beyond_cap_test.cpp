// Values that grow beyond all that is followed.
#include <iostream>

#include "analyzer/analysis.hpp"
#include "analyzer/exact/growth.hpp"
#include "analyzer/exact/zeno_run.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/differential/by_hand.hpp"
#include "tests/support/any_skill.hpp"
#include "tests/support/many_parties.hpp"
#include "tests/support/random_cell.hpp"
#include "tests/support/setting.hpp"
#include "tests/support/stopped_blocks.hpp"
#include "tests/support/timed_skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using pal::test::setting;

namespace {

struct Explored {
  bool complete = false;
  bool over = false;   // a value was measured that is greater than the cap
  bool grows = false;  // one may grow for ever
  Nanoseconds peak = -1;
};

Explored explored(const Machine& machine, Nanoseconds cap) {
  ZoneGraph graph(machine, cap, false);
  Limits limits;
  limits.classes = 3'000;
  const bool complete = graph.explore(limits) && !graph.failure() && !graph.relaxed();
  return {complete, graph.over_cap(), graph.never_answered(), graph.peak().value};
}

/// What is followed up to a low cap against what is followed up to one that no value comes to. How many were
/// compared.
int compare(const Problem& problem, const Requirement& requirement) {
  const bool timed =
      requirement.measure != Requirement::Measure::load && requirement.measure != Requirement::Measure::loss;
  if (!timed) return 0;
  Watch watch = watch_of(problem, requirement);
  const Machine machine(problem, watch);
  const Explored whole = explored(machine, 200'000'000);
  if (!whole.complete || whole.over) return 0;
  int compared = 0;
  for (const Nanoseconds cap : {0, 1'000'000, 3'000'000, 7'000'000}) {
    const Explored part = explored(machine, cap);
    if (!part.complete) continue;
    ++compared;
    INFO(requirement.name << ", cap " << cap << ", greatest " << whole.peak);
    // What is measured as it passes the cap is known yet.
    if (part.over && !watch.least) CHECK(whole.peak > cap);
    if (!part.over || (watch.least && whole.peak <= cap)) CHECK(part.peak == whole.peak);
    if (!watch.grows()) continue;
    watch.limit = cap;
    const GrowthSearch found = growth(problem, watch, cap, {3'000, {}});
    if (found.growth == Growth::ends) CHECK_FALSE((part.over || whole.grows));
    if (found.growth != Growth::counts) continue;
    CHECK((whole.peak > cap || whole.grows));
    REQUIRE(found.witness);
    CHECK(found.witness->measured.value > cap);
  }
  return compared;
}

}  // namespace

TEST_CASE("only values beyond the cap are reported as beyond it") {
  const std::uint64_t first = setting("PAL_SEED", 1);
  int compared = 0;
  for (std::uint64_t seed = first; seed < first + setting("PAL_ROUNDS", 30); ++seed) {
    const std::string text = seed % 4 == 0   ? test::StoppedBlocks(seed).text()
                             : seed % 4 == 1 ? test::TimedSkill(seed).text()
                             : seed % 4 == 2
                                 ? test::ManyParties(seed).text()
                                 : test::RandomCell(seed, 4, 2, test::RandomCell::Asks::all).text();
    const auto skill = test::any_skill(text);
    if (!skill->problem) continue;
    // Where time may stand still nothing is said of what grows.
    if (!find_zeno_run(*skill->problem, {3'000, {}}).excluded) continue;
    INFO("seed " << seed << "\n" << text);
    for (const Requirement& requirement : skill->problem->requirements)
      compared += compare(*skill->problem, requirement);
  }
  CHECK(compared > 0);
  std::cout << compared << " compared\n";
}

TEST_CASE("a late reflection is distinguished from an earlier one") {
  // First 2 ms; then a set, 31 rounds of 10 ms, and 1 ms, counted from the set before.
  CHECK(test::bound(test::program("beyond_cap/late_reaction")) == 312);
}

TEST_CASE("of growing values one that counts is shown") {
  const auto skill = test::any_skill(test::program("beyond_cap/growth_that_counts"));
  REQUIRE(skill->problem);
  const Verdict verdict = analyze_exactly(*skill->problem).verdicts.front();
  CHECK(verdict.state == Verdict::State::fails);
  REQUIRE(verdict.witness);
  CHECK(verdict.witness->grows);
  CHECK(verdict.witness->measured.value > verdict.limit.count());
  // However the run goes on, the skill does not end.
  const Watch watch = watch_of(*skill->problem, skill->problem->requirements.front());
  const Machine machine(*skill->problem, watch);
  SimulationOptions how;
  how.beginning = verdict.witness->script;
  how.until = verdict.witness->measured.at + 1'000'000'000;
  CHECK_FALSE(simulate(machine, how).ended);
}

TEST_CASE("classes explored for growing values are counted") {
  const auto skill = test::any_skill(test::program("beyond_cap/growth_that_counts"));
  REQUIRE(skill->problem);
  const Watch watch = watch_of(*skill->problem, skill->problem->requirements.front());
  const GrowthSearch found = growth(*skill->problem, watch, watch.limit, {});
  CHECK(found.growth == Growth::counts);
  CHECK(found.statistics.classes > 0);
  CHECK(found.statistics.states > 0);
  // All that may be measured is explored up to four times all times of the skill.
  const Machine machine(*skill->problem, watch);
  ZoneGraph graph(machine, 352'000'000, false);
  CHECK(graph.explore({}));
  const std::size_t classes = graph.classes().size() + found.statistics.classes;
  CHECK(analyze_exactly(*skill->problem).statistics.classes == classes);
}

TEST_CASE("a value that has grown when time stands still breaks nothing") {
  const auto skill = test::any_skill(test::program("beyond_cap/grown_in_zeno_run"));
  REQUIRE(skill->problem);
  for (const auto choice : {AnalysisChoice::exact, AnalysisChoice::automatic}) {
    const Analysis analysis = analyze(*skill->problem, choice, {});
    CHECK(analysis.zeno_run);
    CHECK(analysis.verdicts.front().state == Verdict::State::undecided);
  }
}
