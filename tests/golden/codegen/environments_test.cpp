// One skill, generated for two environments and linked into one program: each keeps its own wiring.
#include "tests/golden/codegen/environments.hpp"

#include <catch2/catch.hpp>

TEST_CASE("a skill for two environments is two skills") {
  CHECK(pal::test::executed_elsewhere().environment == "elsewhere");
  CHECK(pal::test::executed_on_its_bench().environment != "elsewhere");
}
