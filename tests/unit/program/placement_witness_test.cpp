// The runs behind `pal whatif --place --witness`.
#include <catch2/catch.hpp>
#include <memory>
#include <string>

#include "analyzer/run_checker/check_run.hpp"
#include "analyzer/runs/quick_runs.hpp"
#include "programs/pal/reports/witness.hpp"
#include "tests/support/skill.hpp"

using namespace pal;
using namespace pal::analyzer;
using namespace pal::analyzer::whatif;

namespace {

/// The touch skill that reads first, in its workcell.
std::unique_ptr<test::Skill> read_first() {
  const std::string root(PAL_SOURCE_DIR);
  return test::skill_from_files(
      {root + "/skills_pal/touch/touch_read_first.pal", root + "/skills_pal/workcell.pal"});
}

}  // namespace

TEST_CASE("when the time is up, no more runs of refuted placements are searched") {
  const auto skill = read_first();
  const pan::Network& network = skill->specification.skills.front();
  const pan::Environment& environment = skill->specification.environments.front();
  RequirementChecker checker(network, Options());
  PlacementOptions how;
  how.most = 20;
  const std::vector<Placements> all{placements_on(2, environment, checker, how)};
  REQUIRE(all.front().refuted.size() == 20);
  CHECK(program::filed_witnesses_of(all, network, environment, {}).size() == 20);

  int asked = 0;
  Options late;
  late.stop = [&asked] { return ++asked > 0; };
  CHECK(program::filed_witnesses_of(all, network, environment, late).empty());
  CHECK(asked == 1);
}

TEST_CASE("a random run that refutes is a run of the problem, up to the breach") {
  const auto skill = read_first();
  const Problem& problem = *skill->problem;
  std::size_t found = 0;
  for (const Requirement& requirement : problem.requirements) {
    const auto witness = simulated_witness(problem, requirement, {}, events_for(1'000'000));
    CHECK(witness.has_value() == (simulated_break(problem, requirement, {}) != Break::none));
    if (!witness) continue;
    ++found;
    CHECK(witness->measured.value > requirement.limit);
    CHECK(witness->script.back().at == witness->measured.at);
    const run_checker::Ruling ruling = run_checker::check_run(problem, &requirement, witness->trace);
    CHECK(ruling.broken.empty());
    REQUIRE_FALSE(ruling.measured.empty());
    CHECK(ruling.measured.back().value == witness->measured.value);
  }
  CHECK(found == 1);
}
