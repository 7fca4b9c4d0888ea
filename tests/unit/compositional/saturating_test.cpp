#include "analyzer/compositional/causes/saturating.hpp"

#include <catch2/catch.hpp>

using namespace pal::analyzer::compositional;

TEST_CASE("a sum with an unbounded time is unbounded") {
  CHECK(plus(3, 4) == 7);
  CHECK(plus(never, 0) == never);
  CHECK(plus(4, never) == never);
  CHECK(plus(never - 1, 1) == never);
}

TEST_CASE("work that does not fit is unbounded") {
  CHECK(work_of(3, 4) == 12);
  CHECK(work_of(never, 0) == 0);
  CHECK(work_of(never, 2) == never);
  CHECK(work_of(2, never) == never);
}
