// What is nearest.
#include "skills_pal/sensing/nearest_point.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/sensing/shapes.hpp"

namespace pal::sensing {
namespace {

using test::outline;
using test::scan;
using test::Scan;

TEST_CASE("nearest point: standoff from 150 to 450 mm, within half the stated error", "[nearest-point]") {
  std::mt19937 random(6);
  const double lean = GENERATE(0.0, 0.05, -0.3);
  double worst = 0;  // in stated errors
  for (double z = 150; z <= 450; z += 1) {
    // The end of the fan is nearest, where the plane leans towards it; else any place.
    const double exact = z / (1 + std::abs(lean) * std::tan(20 * 0.017453292519943295));
    const Scan seen = scan(outline({{-600, z - 600 * lean}, {600, z + 600 * lean}}), random);
    const auto nearest = find_nearest_point(seen.profile());
    REQUIRE(nearest);
    if (std::abs(nearest->z - exact) / test::stated_error(exact) > .5) WARN(z << " exact " << exact << " got " << nearest->z << " at y " << nearest->y);
    worst = std::max(worst, std::abs(nearest->z - exact) / test::stated_error(exact));
  }
  WARN("nearest point of a plane that leans " << lean << ": at most " << worst << " of the stated error off");
  CHECK(worst < 0.5);
}

TEST_CASE("nearest point: a narrow thing counts, a spike does not", "[nearest-point]") {
  std::mt19937 random(7);
  Scan seen = scan(outline({{-300, 220}, {10, 220}, {10, 190}, {14, 190}, {14, 220}, {300, 220}}), random);
  seen.z[40] = 120;
  seen.z[41] = 125;
  const auto nearest = find_nearest_point(seen.profile());
  REQUIRE(nearest);
  CHECK(nearest->z == Approx(190).margin(0.2));
  CHECK(nearest->y > 9.5);
  CHECK(nearest->y < 14.5);
}

TEST_CASE("nearest point: nothing in range is nothing", "[nearest-point]") {
  std::mt19937 random(7);
  CHECK_FALSE(find_nearest_point(scan(outline({{-300, 50}, {300, 50}}), random).profile()));
  CHECK_FALSE(find_nearest_point({}));
}

}  // namespace
}  // namespace pal::sensing
