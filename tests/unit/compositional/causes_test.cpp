// Which segment triggers which.
#include <catch2/catch.hpp>

#include "analyzer/compositional/causes/refusal.hpp"
#include "tests/unit/compositional/stages.hpp"

using namespace pal::analyzer;
using namespace pal::analyzer::compositional;
using pal::test::chain;
using pal::test::ms;
using pal::test::Stages;

TEST_CASE("the source of an event has the segments that its message leads to") {
  const Stages stages(chain("    work\n    SPC( pc-high )"));
  REQUIRE(stages.forest.refusal.empty());
  const NodeId looks = stages.job("LS1");
  const NodeId works = stages.job("SM1");
  const Source& source = stages.context.source(looks);
  CHECK(source.kind == Source::Kind::event);
  CHECK(source.period == 20 * ms);
  CHECK(source.roots == std::vector<NodeId>{looks});
  CHECK(stages.context.node(works).cause == looks);
  CHECK(stages.context.node(works).release == Node::Release::message);
  CHECK(stages.forest.cause_in(works, stages.thread("LS1")) == looks);
  CHECK(!stages.forest.cause_in(looks, stages.thread("SM1")).valid());
}

TEST_CASE("a cause stands before its effects") {
  const Stages stages(chain("    work\n    SPC( pc-high )"));
  for (const NodeId n : stages.forest.nodes.ids()) CHECK(stages.forest.nodes[n].cause < n);
}

TEST_CASE("the start of a module is a source that occurs once") {
  const Stages stages(chain("    work\n    SPC( pc-high )"));
  int starts = 0;
  for (const Source& source : stages.forest.sources) {
    if (source.kind != Source::Kind::start) continue;
    ++starts;
    CHECK(source.period == never);
  }
  CHECK(starts == 2);
}

TEST_CASE("several waits for one message that answers nothing are refused, with the reason") {
  const Stages stages(chain("    work\n    WTM( value from LS1 )\n    SPC( pc-high )"));
  CHECK_FALSE(stages.forest.refusal.empty());
  CHECK(stages.forest.refusal.text ==
        refusal_of(stages.problem, stages.forest.segments, pal::test::goes_on).text);
}

TEST_CASE("no forest is built after a stop was requested") {
  const Stages stages(chain("    work\n    SPC( pc-high )"));
  CHECK_FALSE(forest_of(stages.problem, [] { return true; }).refusal.empty());
}
