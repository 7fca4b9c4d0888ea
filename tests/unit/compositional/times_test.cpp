// When each segment is released and done.
#include "analyzer/compositional/times/times.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/compositional/stages.hpp"

using namespace pal::analyzer;
using namespace pal::analyzer::compositional;
using pal::test::chain;
using pal::test::ms;
using pal::test::Stages;

TEST_CASE("a segment is released by its cause, and done after its own work") {
  const Stages stages(chain("    work\n    SPC( pc-high )"));
  const NodeTimes& looks = stages.times.nodes[stages.job("LS1")];
  const NodeTimes& works = stages.times.nodes[stages.job("SM1")];
  CHECK(looks.earliest == 0);
  CHECK(looks.latest == 0);
  CHECK(looks.finish == 2 * ms);
  CHECK(works.earliest == 1 * ms);
  CHECK(works.latest == 2 * ms);
  CHECK(works.finish == 5 * ms);
}

TEST_CASE("the greatest inter-arrival time of a regular event is its period") {
  const Stages stages(chain("    work\n    SPC( pc-high )"));
  const SourceId source = stages.context.node(stages.job("LS1")).source;
  CHECK(stages.times.longest_gap[source].at == 20 * ms);
  CHECK(stages.times.no_overrun[source]);
}

TEST_CASE("the latest effect of a step that a node does not have is unbounded") {
  const Stages stages(chain("    work\n    SPC( pc-high )"));
  const NodeId looks = stages.job("LS1");
  const NodeId works = stages.job("SM1");
  const StepId last = stages.context.segment(works).steps.back().step;
  CHECK(latest_effect(stages.forest, stages.times.nodes, works, last) == 5 * ms);
  CHECK(latest_effect(stages.forest, stages.times.nodes, looks, last) == never);
  CHECK(earliest_effect(stages.forest, stages.times, works, last) == 4 * ms);
}
