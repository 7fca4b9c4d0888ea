// The map of the edge, and the clock that tells when ALTER's requests come.
#include "skills_pal/follow_edge/edge_map.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "skills_pal/modules/cycle_clock.hpp"

using namespace pal::skills;

TEST_CASE("the map continues the edge as a point, a line or a parabola") {
  EdgeMap map;
  map.start(10);
  const Eigen::Vector3d heading = Eigen::Vector3d::UnitX();
  CHECK_FALSE(map.at(Eigen::Vector3d::Zero(), heading));
  const auto edge = [](double x) { return Eigen::Vector3d(x, 0.2 * x + 0.003 * x * x, 200 - 0.1 * x); };
  map.add(edge(0), Eigen::Vector3d::UnitY());
  CHECK(map.at({2, 0, 0}, heading)->along.isApprox(heading));
  for (double x = 0.8; x <= 30; x += 0.8) map.add(edge(x), Eigen::Vector3d::UnitY());
  // 5 mm beyond the last point.
  const auto place = map.at({34.6, 0, 0}, heading);
  REQUIRE(place);
  CHECK((place->point - edge(34.6)).norm() < 0.05);
  const Eigen::Vector3d along = Eigen::Vector3d(1, 0.2 + 0.006 * 34.6, -0.1).normalized();
  CHECK(std::acos(std::min(1.0, place->along.dot(along))) < 0.01);
}

TEST_CASE("the clock finds out when requests come to within 3 ms") {
  const double phase = GENERATE(0.0, 5.0, 13.7, 27.0);
  CycleClock clock;
  clock.start();
  double known = 76;
  for (int cycle = 1; cycle <= 200; ++cycle) {
    clock.tick();
    const double now = phase + 28 * cycle;
    if (known <= now) {
      clock.saw(known);
      known += 78;
    }
  }
  CAPTURE(phase);
  CHECK(clock.instant(200) == Approx(phase + 28 * 200).margin(3));
}
