// Which segments never overlap.
#include <catch2/catch.hpp>

#include <algorithm>

#include "analyzer/compositional/causes/alternatives.hpp"
#include "analyzer/compositional/causes/exclusive.hpp"
#include "tests/unit/compositional/stages.hpp"

using namespace pal::analyzer;
using namespace pal::analyzer::compositional;
using pal::test::chain;
using pal::test::Stages;

namespace {

bool has(const std::vector<NodeId>& nodes, NodeId node) {
  return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
}

}  // namespace

TEST_CASE("within one occurrence a segment never overlaps with its cause") {
  const Stages stages(chain("    work\n    SPC( pc-high )"));
  const NodeId looks = stages.job("LS1");
  const NodeId works = stages.job("SM1");
  const auto apart = never_together(stages.problem, stages.forest, pal::test::goes_on);
  CHECK(has(apart[works], looks));
}

TEST_CASE("a cause and its effect are no alternatives") {
  const Stages stages(chain("    work\n    SPC( pc-high )"));
  CHECK_FALSE(are_alternatives(stages.problem, stages.forest, {stages.job("LS1"), stages.job("SM1")}));
}

TEST_CASE("effects of two branches of a job are exclusive, effects in a row are not") {
  const Stages stages(chain(R"(    work
    SPC( pc-high )
    CASE
      ( pc-high = TRUE ):
        work
      ( pc-high = FALSE ):
        rest
    END CASE)"));
  const NodeId job = stages.job("SM1");
  std::vector<StepEffect> effects;
  for (const Segment::Passed& passed : stages.context.segment(job).steps) {
    if (stages.context.step_at(passed.step).kind == Step::Kind::activity)
      effects.push_back({job, passed.step});
  }
  REQUIRE(effects.size() == 3);
  CHECK(are_exclusive(stages.context, {effects[1], effects[2]}));
  CHECK_FALSE(are_exclusive(stages.context, {effects[0], effects[2]}));
}
