// Values that grow beyond all that is followed.
#include "analyzer/exact/growth.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/attack/by_hand.hpp"
#include "tests/support/project_file.hpp"

using namespace pal;
using namespace pal::analyzer;

TEST_CASE("what is reflected late is told from what was reflected before") {
  // First 2 ms; then a set, 31 rounds of 10 ms, and 1 ms, counted from the set before.
  CHECK(test::bound(test::project_file("tests/attack/late_reaction.pal")) == 312);
}

TEST_CASE("of values that grow one is shown that counts") {
  const auto skill = test::any_skill(test::project_file("tests/attack/growth_that_counts.pal"));
  REQUIRE(skill->problem);
  const Verdict verdict = analyze(*skill->problem).verdicts.front();
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

TEST_CASE("classes explored for what grows are counted") {
  const auto skill = test::any_skill(test::project_file("tests/attack/growth_that_counts.pal"));
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
  CHECK(analyze(*skill->problem).statistics.classes == classes);
}
