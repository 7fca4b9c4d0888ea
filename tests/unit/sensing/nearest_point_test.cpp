// What is nearest.
#include "skills_pal/sensing/nearest_point.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/sensing/shapes.hpp"

namespace pal::skills::sensing {
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
    worst = std::max(worst, std::abs(nearest->z - exact) / test::stated_error(exact));
  }
  INFO("nearest point of a plane that leans " << lean << ": at most " << worst << " of the stated error off");
  CHECK(worst < 0.5);
}

TEST_CASE("nearest point: of a ridge, and of a round thing", "[nearest-point]") {
  std::mt19937 random(6);
  double ridge = 0, round = 0;  // the worst, in stated errors
  for (int i = 0; i < 200; ++i) {
    const double y = std::uniform_real_distribution<double>(-20, 20)(random);
    const Scan roof = scan(outline({{y - 300, 370}, {y, 200}, {y + 300, 370}}), random);
    const auto top = find_nearest_point(roof.profile());
    REQUIRE(top);
    ridge = std::max(ridge, std::abs(top->z - 200) / test::stated_error(200));
    test::Outline bar;
    for (double a = -1.4; a <= 1.4; a += 0.02) bar.push_back({y + 50 * std::sin(a), 250 - 50 * std::cos(a)});
    const auto crest = find_nearest_point(scan(outline(bar), random).profile());
    REQUIRE(crest);
    round = std::max(round, std::abs(crest->z - 200) / test::stated_error(200));
  }
  INFO("nearest point: at most " << ridge << " of the stated error off a ridge, " << round << " off a bar");
  CHECK(ridge < 2.5);
  CHECK(round < 2.5);
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
}  // namespace pal::skills::sensing
