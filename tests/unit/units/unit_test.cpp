#include <catch2/catch.hpp>

#include "pal/units/unit.hpp"

using namespace pal::units;

namespace {

std::optional<Ratio> factor(const char* from, const char* to) {
  const auto left = parse_unit(from);
  const auto right = parse_unit(to);
  REQUIRE(left);
  REQUIRE(right);
  return pal::units::factor(*left, *right);
}

}  // namespace

TEST_CASE("units of one dimension convert by exact fractions") {
  CHECK(factor("cm", "mm") == Ratio{10, 1});
  CHECK(factor("mm", "cm") == Ratio{1, 10});
  CHECK(factor("km/min", "mm/s") == Ratio{50000, 3});
  CHECK(factor("N/mm", "N/m") == Ratio{1000, 1});
  CHECK(factor("mm/s^2", "m/s^2") == Ratio{1, 1000});
  CHECK(factor("min", "ns") == Ratio{60'000'000'000, 1});
  CHECK(factor("bar", "kPa") == Ratio{100, 1});
  CHECK(factor("deg/s", "deg/ms") == Ratio{1, 1000});
}

TEST_CASE("units of the yard and the pound are exact") {
  CHECK(factor("in", "mm") == Ratio{127, 5});
  CHECK(factor("ft", "in") == Ratio{12, 1});
  CHECK(factor("lb", "g") == Ratio{45359237, 100000});
  CHECK(factor("kgf", "N") == Ratio{196133, 20000});
  CHECK(factor("kgf", "lbf") == factor("kg", "lb"));
  CHECK(factor("psi", "lbf/in^2") == Ratio{1, 1});
}

TEST_CASE("turns convert to degrees, and not to radians") {
  CHECK(factor("rev", "deg") == Ratio{360, 1});
  CHECK(factor("rpm", "deg/s") == Ratio{6, 1});
  CHECK(factor("rpm", "rev/min") == Ratio{1, 1});
  CHECK_FALSE(factor("rpm", "rad/s"));
  CHECK_FALSE(factor("rpm", "Hz"));
  CHECK(factor("mrad", "rad") == Ratio{1, 1000});
}

TEST_CASE("litres, hours and the larger and smaller units") {
  CHECK(factor("l/min", "m^3/h") == Ratio{3, 50});
  CHECK(factor("ml", "cm^3") == Ratio{1, 1});
  CHECK(factor("mbar", "Pa") == Ratio{100, 1});
  CHECK(factor("MPa", "N/mm^2") == Ratio{1, 1});
  CHECK(factor("MHz", "kHz") == Ratio{1000, 1});
  CHECK(factor("kW", "mW") == Ratio{1000000, 1});
}

TEST_CASE("one unit in two spellings is the same unit") {
  CHECK(factor("N*m", "J") == Ratio{1, 1});
  CHECK(factor("V*A", "W") == Ratio{1, 1});
  CHECK(factor("kg*m/s^2", "N") == Ratio{1, 1});
  CHECK(factor("m*s^-1", "m/s") == Ratio{1, 1});
  CHECK(factor("Hz", "s^-1") == Ratio{1, 1});
}

TEST_CASE("what has no exact conversion has none") {
  CHECK_FALSE(factor("mm", "N"));
  CHECK_FALSE(factor("deg", "rad"));
  CHECK_FALSE(factor("degC", "K"));
  CHECK_FALSE(factor("rad", "count"));
  CHECK_FALSE(factor("%", "rad"));
  CHECK(factor("W/degC", "W/K") == Ratio{1, 1});
}

TEST_CASE("a text that is not a unit is recognised") {
  for (const char* text : {"", "furlong", "m^", "m^0", "m^12", "m**s", "/s", "m/", "% ", "m%", "Mm"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_unit(text));
  }
  CHECK_FALSE(parse_unit("km^9"));
}
