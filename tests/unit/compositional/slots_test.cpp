#include "analyzer/compositional/times/slots.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/compositional/stages.hpp"

using namespace pal::analyzer;
using namespace pal::analyzer::compositional;
using pal::test::chain;
using pal::test::ms;
using pal::test::Stages;

TEST_CASE("jobs that are over within the period are done before the next") {
  const Stages stages(chain("    work\n    SPC( pc-high )"));
  CHECK(is_done_before_next(stages.context, stages.times.nodes, stages.thread("SM1")));
  CHECK(take_in_time(stages.context, stages.times.nodes, stages.job("SM1"), 20 * ms));
  CHECK(Slots(stages.context).unbounded_threads(stages.times).empty());
}
