// How threads behave: jobs, and the wait at which they are idle.
#include <catch2/catch.hpp>

#include "tests/unit/compositional/stages.hpp"

using namespace pal::analyzer;
using namespace pal::analyzer::compositional;
using pal::test::chain;
using pal::test::Stages;

TEST_CASE("a thread that waits, works and waits again does jobs") {
  const Stages stages(chain("    work\n    SPC( pc-high )"));
  for (const char* name : {"LS1", "SM1"}) {
    const ThreadBehaviour& thread = stages.context.behaviour_of(stages.thread(name));
    CHECK(thread.idle_wait.valid());
    CHECK(thread.job_starts.size() == 1);
    CHECK(thread.unbounded_reason.empty());
    CHECK(thread.one_job);
  }
  CHECK(in_job(stages.forest, stages.behaviours, stages.job("SM1")));
}

TEST_CASE("what a thread does before its first job is early") {
  const Stages stages(chain("    work\n    SPC( pc-high )"));
  const ThreadId sm1 = stages.thread("SM1");
  int early = 0;
  for (const NodeId n : stages.context.behaviour_of(sm1).nodes) {
    if (stages.behaviours.early[n]) ++early;
  }
  CHECK(early == 1);
  CHECK_FALSE(stages.behaviours.early[stages.job("SM1")]);
}
