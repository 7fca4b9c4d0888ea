// Modules with a CONCURRENT that blocks execute, worked out by hand from docs/reference/execution-model.md.
#include "tests/differential/by_hand.hpp"

using pal::test::bound;
using pal::test::program;

TEST_CASE("two blocks that execute one module at the same time have their own blocks of it") {
  // The first has short until 1 ms, then the second its rest until 2; its work is done elsewhere than the
  // first's, which lasts until 3.
  CHECK(bound(program("executed_blocks/at_a_time")) == 5);
}

TEST_CASE("open requests of an executed module's blocks are withdrawn with the block that executes it") {
  // MC2.1 asks at 0 and ends at 1, the block that executes MC2 is stopped at 2: the answer of 5 ms is
  // discarded, and the next request answered at 10.
  CHECK(bound(program("executed_blocks/left_open")) == 10);
}

TEST_CASE("a block of an executed module that has none of its own runs where the module does") {
  // CM1.2 stands in CM1.1, which has a place; it runs where SM1.1 does, and waits there for SM1.2.
  CHECK(bound(program("executed_blocks/runs_where_module_does")) == 7);
}
