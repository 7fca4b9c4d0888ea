// The edge as the thesis finds it, beside the one by two lines.
#include "skills_pal/sensing/literal_edge.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/sensing/shapes.hpp"

namespace pal::skills::sensing {
namespace {

using test::outline;
using test::scan;
using test::Scan;

TEST_CASE("literal edge: the end of the nearer surface, and how it leans", "[edge]") {
  std::mt19937 random(2);
  const bool mirrored = GENERATE(false, true);
  double squares = 0;
  const int profiles = 200;
  for (int i = 0; i < profiles; ++i) {
    // Mirrored, the wall must be out of view: the thesis' mask takes the one point of it for the surface.
    const double y = std::uniform_real_distribution<double>(-20, mirrored ? 0 : 20)(random);
    const double lean = 0.1;  // 5.7 degrees
    const Scan seen =
        mirrored ? scan(outline({{-300, 230}, {y, 230}, {y, 200}, {300, 200 + lean * (300 - y)}}), random)
                 : scan(outline({{-300, 200 - lean * (300 + y)}, {y, 200}, {y, 230}, {300, 230}}), random);
    const std::optional<LiteralEdge> edge = find_literal_edge(seen.profile());
    REQUIRE(edge);
    squares += (edge->y - y) * (edge->y - y);
    REQUIRE(edge->z == Approx(200).margin(2.5));
    REQUIRE(edge->slope == Approx(5.71).margin(1));
  }
  INFO("literal edge at 200 mm: rms " << std::sqrt(squares / profiles) << " mm in y");
  CHECK(std::sqrt(squares / profiles) <
        1);  // a point is 0.55 mm wide, and the last may lie on the step itself
}

TEST_CASE("literal edge: says that there is none", "[edge]") {
  std::mt19937 random(4);
  CHECK_FALSE(find_literal_edge(scan(outline({{-300, 200}, {300, 200}}), random).profile()));
  CHECK_FALSE(find_literal_edge(scan(outline({{-300, 2000}, {300, 2000}}), random).profile()));
  CHECK_FALSE(find_literal_edge({}));
}

}  // namespace
}  // namespace pal::skills::sensing
