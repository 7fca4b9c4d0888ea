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

TEST_CASE("a receiver that takes longer than the period may find its slot full, and its sender is named") {
  const Stages stages(chain("    work\n    SPC( pc-high )", "TIME SM1.work : 25 ms\n"));
  CHECK_FALSE(stages.times.unbounded_reason[static_cast<std::size_t>(stages.thread("SM1"))].empty());
}
