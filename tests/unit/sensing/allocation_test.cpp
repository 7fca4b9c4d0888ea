// Activities must not allocate while a skill runs; so their arithmetic must not.
#include <catch2/catch.hpp>
#include <vector>

#include "skills_pal/sensing/edge.hpp"
#include "skills_pal/sensing/literal_edge.hpp"
#include "skills_pal/sensing/motion.hpp"
#include "skills_pal/sensing/nearest_point.hpp"
#include "skills_pal/sensing/plane.hpp"
#include "tests/run/support/allocation_count.hpp"
#include "tests/unit/sensing/shapes.hpp"

namespace pal::skills::sensing {
namespace {

TEST_CASE("sensing: nothing is allocated") {
  std::mt19937 random(1);
  const test::Scan roof = test::scan(test::outline({{-300, 300}, {0, 200}, {300, 300}}), random);
  const test::Scan step =
      test::scan(test::outline({{-300, 200}, {-10, 200}, {-10, 230}, {300, 230}}), random);
  std::vector<Eigen::Vector3d> points(4 * most_points);
  ToolMotion motion;
  pal::test::reset_allocations();
  pal::test::count_allocations(true);
  const bool edge = find_edge(roof.profile()).has_value();
  const bool literal = find_literal_edge(step.profile()).has_value();
  const bool nearest = find_nearest_point(roof.profile()).has_value();
  std::size_t count = 0;
  for (int i = 0; i < 4; ++i) {
    motion.add(100 * i, Eigen::Isometry3d(Eigen::Translation3d(10 * i, 0, 0)));
    count += compensate(step.profile(), 100 * i, motion, 0, std::span(points).subspan(count));
  }
  const bool plane = find_plane({points.data(), count}, {.thickness = 50}).has_value();
  pal::test::count_allocations(false);
  CHECK(pal::test::counted_allocations() == 0);
  CHECK(edge);
  CHECK(literal);
  CHECK(nearest);
  CHECK(plane);
}

}  // namespace
}  // namespace pal::skills::sensing
