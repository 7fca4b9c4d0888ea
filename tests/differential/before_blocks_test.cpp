// Slices of skills that wait, before their blocks begin, for a party that is left out.
#include <catch2/catch.hpp>

#include "tests/differential/agreed.hpp"

using pal::test::agreed_bounds;
using pal::test::Bounds;
using pal::test::proved_bounds;

TEST_CASE("a slice knows how long a send and a wait before the blocks last") {
  const Bounds exact{{"sent", 13}, {"tight", 13}};
  CHECK(agreed_bounds("before_blocks/asked_between") == exact);
  CHECK(proved_bounds("before_blocks/asked_between") == exact);
}

TEST_CASE("in a slice a client that is left out may give up what a server is about to take") {
  CHECK(agreed_bounds("before_blocks/given_up") == Bounds{{"answered", 9}});
  // It may do so again and again.
  CHECK(proved_bounds("before_blocks/given_up").empty());
}
