// Modules with a CONCURRENT that blocks execute, worked out by hand from docs/reference/execution-model.md.
#include "tests/differential/by_hand.hpp"

using pal::test::bound;
using pal::test::program;

TEST_CASE("two blocks that execute one module each have their own blocks of it") {
  // The first has short until 1 ms, then the second its rest until 2; its work is done elsewhere than the
  // first's, which lasts until 3.
  CHECK(bound(program("executed_blocks/at_a_time")) == 5);
}

TEST_CASE("cancelling a block withdraws the requests of the blocks that it executes") {
  // MC2.1 asks at 0 and ends at 1. The block that executes MC2 is stopped at 2. So the answer of 5 ms is
  // discarded, and the next request answered at 10.
  CHECK(bound(program("executed_blocks/left_open")) == 10);
}

TEST_CASE("a block of an executed module without a place runs where the module runs") {
  // CM1.2 stands in CM1.1, which has a place; it runs where SM1.1 does, and waits there for SM1.2.
  CHECK(bound(program("executed_blocks/runs_where_module_does")) == 7);
}
