#include "analyzer/zones/dbm.hpp"

#include <catch2/catch.hpp>

using pal::analyzer::Dbm;

namespace {

/// Two variables, each in [0, 10].
Dbm square() {
  Dbm zone(3);
  for (std::size_t i = 1; i < 3; ++i) {
    zone.at(i, 0) = 10;
    zone.at(1, 2) = zone.at(2, 1) = 10;
  }
  return zone;
}

}  // namespace

TEST_CASE("a constraint tightens the bounds that follow from it") {
  Dbm zone = square();
  REQUIRE(zone.constrain(1, 2, -4));  // x1 + 4 <= x2
  CHECK(zone.at(1, 0) == 6);
  CHECK(zone.at(0, 2) == -4);
}

TEST_CASE("contradictory constraints make a zone empty") {
  Dbm zone = square();
  REQUIRE(zone.constrain(1, 2, -4));
  CHECK_FALSE(zone.constrain(2, 0, 3));
}

TEST_CASE("a zone includes one that is constrained further, and is not included in it") {
  const Dbm whole = square();
  Dbm part = square();
  REQUIRE(part.constrain(1, 0, 5));
  CHECK(whole.includes(part));
  CHECK_FALSE(part.includes(whole));
}
