#include "analyzer/compositional/causes/segment.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/compositional/stages.hpp"

using namespace pal::analyzer;
using namespace pal::analyzer::compositional;
using pal::test::chain;
using pal::test::ms;
using pal::test::Stages;

namespace {

const Segment& segment_of_job(const Stages& stages, const std::string& thread) {
  return stages.context.segment(stages.job(thread));
}

}  // namespace

TEST_CASE("a segment goes from one wait to the next") {
  const Stages stages(chain("    work\n    SPC( pc-high )"));
  const Segment& looks = segment_of_job(stages, "LS1");
  CHECK(looks.beginning.kind == Beginning::Kind::arm);
  CHECK(looks.waits.size() == 1);
  CHECK(looks.worst == 2 * ms);
  CHECK(looks.waits.front().best == 1 * ms);
  CHECK_FALSE(looks.ends);
  CHECK_FALSE(looks.spins);
}

TEST_CASE("of the branches of a segment the longest counts, and the shortest") {
  const Stages stages(chain(R"(    SPC( pc-high )
    CASE
      ( pc-high = TRUE ):
        work
      ( pc-high = FALSE ):
        rest
    END CASE)"));
  const Segment& works = segment_of_job(stages, "SM1");
  CHECK(works.worst == 5 * ms);
  CHECK(works.waits.front().best == 3 * ms);
  CHECK(may_end(stages.problem, works));
}

TEST_CASE("steps of two branches never come in a row, steps of one do") {
  const Stages stages(chain(R"(    work
    SPC( pc-high )
    CASE
      ( pc-high = TRUE ):
        work
      ( pc-high = FALSE ):
        rest
    END CASE)"));
  const Segment& works = segment_of_job(stages, "SM1");
  std::vector<StepId> activities;
  for (const Segment::Passed& passed : works.steps) {
    if (stages.problem.steps[passed.step].kind == Step::Kind::activity) activities.push_back(passed.step);
  }
  REQUIRE(activities.size() == 3);
  CHECK(any_in_row(stages.problem, works, activities));
  CHECK_FALSE(any_in_row(stages.problem, works, {activities[1], activities[2]}));
  const pal::Table<StepId, bool> after = steps_after(stages.problem, works, activities[0]);
  CHECK(after[activities[1]]);
  CHECK_FALSE(after[activities[0]]);
}
