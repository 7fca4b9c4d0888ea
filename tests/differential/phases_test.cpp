// Requirements on a part of each run.
#include <catch2/catch.hpp>

#include "tests/differential/agreed.hpp"

using pal::test::agreed_bounds;
using pal::test::Bounds;
using pal::test::never_measured;
using pal::test::sliced_bounds;
using pal::test::without_bound;

TEST_CASE("a phase leaves out start-up and contingency") {
  // A tick every 10 ms, 1 to 2 ms for each, 1 to 3 ms for a level. Start-up settles for up to 22 ms, the
  // contingency retreats for 24.
  CHECK(agreed_bounds("phases/loop") == Bounds{{"age-run", 34},
                                               {"age-loop", 34},
                                               {"age-after", 24},
                                               {"sample-run", 37},
                                               {"sample-loop", 37},
                                               {"response-run", without_bound},
                                               {"response-loop", 2},
                                               {"response-after", without_bound},
                                               {"interval-run", 27},
                                               {"interval-loop", 11},
                                               {"interval-after", 27},
                                               {"least-loop", 9},
                                               {"least-after", 9},
                                               {"reaction-run", 61},
                                               {"reaction-loop", 22},
                                               {"reaction-after", 37},
                                               {"noticed-loop", 22},
                                               {"noticed-after", 39},
                                               {"loss-run", 1},
                                               {"loss-loop", 0},
                                               {"loss-after", never_measured},
                                               {"whole", without_bound},
                                               {"rest", 0}});
}

TEST_CASE("a phase may be a loop of another module, with what it executes") {
  // Before and behind the loop SM1 thinks for 6 ms, on MC1's processor and before it.
  CHECK(agreed_bounds("phases/other_module") == Bounds{{"age-loop", 8},
                                                       {"age-run", 8},
                                                       {"response-loop", 6},
                                                       {"response-run", 12},
                                                       {"response-tail", 6},
                                                       {"interval-loop", 18},
                                                       {"interval-run", 18},
                                                       {"reaction-loop", 22},
                                                       {"reaction-tail", 22},
                                                       {"loss-loop", 0},
                                                       {"loss-run", 0}});
}

TEST_CASE("a phase may begin before or behind what is measured at the same instant") {
  CHECK(agreed_bounds("phases/one_instant") == Bounds{{"after-take", 8},
                                                      {"after-put", 8},
                                                      {"put-to-put", 4},
                                                      {"in-loop", 8},
                                                      {"out-of-loop", 10},
                                                      {"reaction-loop", 2},
                                                      {"reaction-put", 12},
                                                      {"whole", 8}});
}

TEST_CASE("a slice keeps what begins and ends a phase, and gives the same bounds") {
  for (const std::string name : {"phases/loop", "phases/other_module", "phases/one_instant"}) {
    INFO(name);
    CHECK(sliced_bounds(name) == pal::test::explored_bounds(name));
  }
}
