// Edges by two lines.
#include "skills_pal/sensing/edge.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/unit/sensing/shapes.hpp"

namespace pal::skills::sensing {
namespace {

using test::outline;
using test::scan;
using test::Scan;

constexpr double degree = std::numbers::pi / 180;

/// Two surfaces that lean by `left` and `right` degrees and meet at (y, z).
test::Shape crease(double y, double z, double left, double right) {
  return outline(
      {{y - 300, z - 300 * std::tan(left * degree)}, {y, z}, {y + 300, z + 300 * std::tan(right * degree)}});
}

/// A level surface at z up to y, and then one at `far`.
test::Shape step(double y, double z, double far) {
  return outline({{-500, z}, {y, z}, {y, far}, {500, far}});
}

/// The other way round: the farther surface is scanned first.
test::Shape step_up(double y, double z, double far) {
  return outline({{-500, far}, {y, far}, {y, z}, {500, z}});
}

/// Root mean squares of the errors over profiles with the edge in many places.
struct Errors {
  double y = 0, z = 0, slope = 0;
  double greatest_y = 0;
  int found = 0;
};

template <class Make>
Errors errors_of(Make make, double z, double slope) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> places(-30, 30);
  Errors errors;
  const int profiles = 400;
  for (int i = 0; i < profiles; ++i) {
    const double y = places(random);
    const Scan seen = scan(make(y), random);
    const std::optional<Edge> edge = find_edge(seen.profile());
    if (!edge) continue;
    ++errors.found;
    errors.y += (edge->y - y) * (edge->y - y);
    errors.z += (edge->z - z) * (edge->z - z);
    errors.slope += std::pow(edge->beside().angle() - slope, 2);
    errors.greatest_y = std::max(errors.greatest_y, std::abs(edge->y - y));
  }
  for (double* sum : {&errors.y, &errors.z, &errors.slope}) *sum = std::sqrt(*sum / errors.found);
  errors.found -= profiles;
  return errors;
}

TEST_CASE("edge: where two surfaces meet, within 0.2 mm rms at 200 mm", "[edge]") {
  const auto [left, right] =
      GENERATE(table<double, double>({{0, 45}, {-30, 30}, {-10, 10}, {20, -20}, {0, 15}}));
  const Errors errors = errors_of([&](double y) { return crease(y, 200, left, right); }, 200, left);
  INFO("crease of " << left << " and " << right << " deg: rms " << errors.y << " mm in y, " << errors.z
                    << " mm in z, " << errors.slope << " deg; greatest " << errors.greatest_y << " mm in y");
  CHECK(errors.found == 0);  // all of them
  CHECK(errors.y < 0.2);
  CHECK(errors.z < 0.1);
  CHECK(errors.slope < 0.5);
}

TEST_CASE("edge: beside a step no other edge is found", "[edge]") {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> places(5, 25);
  for (const double far : {203, 206, 215, 260})
    for (int i = 0; i < 100; ++i) {
      const double y = places(random);
      const Scan seen = scan(step(y, 200, far), random);
      EdgeOptions options;
      options.expected = 0;
      const std::optional<Edge> edge = find_edge(seen.profile(), options);
      CAPTURE(far, y);
      REQUIRE(edge);
      CHECK(edge->y == Approx(y).margin(1));
    }
}

TEST_CASE("edge: the end of a step's nearer surface, within 0.2 mm rms at 200 mm", "[edge]") {
  const double far = GENERATE(203, 215, 260);
  const bool up = GENERATE(false, true);
  // The wall below the edge is in view from half of the places. Going up it costs the nearer surface a point.
  const Errors errors =
      errors_of([&](double y) { return up ? step_up(y, 200, far) : step(y, 200, far); }, 200, 0);
  INFO("step " << (up ? "up from " : "down to ") << far << " mm: rms " << errors.y << " mm in y, " << errors.z
               << " mm in z, " << errors.slope << " deg; greatest " << errors.greatest_y << " mm in y");
  CHECK(errors.found == 0);
  CHECK(errors.y < 0.2);
  CHECK(errors.z < 0.1);
  CHECK(errors.slope < 0.5);
}

TEST_CASE("edge: exact without noise", "[edge]") {
  std::mt19937 random(1);
  const Scan seen = scan(crease(12.34, 200, -20, 20), random, 0);
  const std::optional<Edge> edge = find_edge(seen.profile());
  REQUIRE(edge);
  CHECK(edge->kind == EdgeKind::crease);
  CHECK(edge->y == Approx(12.34).margin(0.05));
  CHECK(edge->z == Approx(200).margin(0.03));
  CHECK(edge->left.angle() == Approx(-20).margin(0.1));
  CHECK(edge->right.angle() == Approx(20).margin(0.1));
}

TEST_CASE("edge: says that there is none", "[edge]") {
  std::mt19937 random(11);
  int seen = 0;
  const int profiles = 1000;
  SECTION("on a plane, however it leans and far it is") {
    std::uniform_real_distribution<double> leans(-30, 30), distances(150, 600);
    for (int i = 0; i < profiles; ++i) {
      const double lean = leans(random);
      seen += find_edge(scan(crease(0, distances(random), lean, lean), random).profile()) ? 1 : 0;
    }
  }
  SECTION("on waves") {
    // 8 mm high and 200 mm long; curves as much as 4 degrees over the points that are looked at.
    for (int i = 0; i < profiles; ++i) {
      test::Outline waves;
      const double phase = std::uniform_real_distribution<double>(0, 2 * std::numbers::pi)(random);
      for (double y = -150; y <= 150; y += 1) {
        waves.push_back({y, 200 + 4 * std::sin(phase + 2 * std::numbers::pi * y / 200)});
      }
      seen += find_edge(scan(outline(waves), random).profile()) ? 1 : 0;
    }
  }
  SECTION("where nothing is in range") {
    seen += find_edge(scan(crease(0, 2000, 0, 0), random).profile()) ? 1 : 0;
  }
  CHECK(seen == 0);
}

TEST_CASE("edge: of several the one that is expected, else the clearest", "[edge]") {
  std::mt19937 random(3);
  const Scan seen =
      scan(outline({{-200, 210}, {-25, 210}, {-25, 205}, {20, 205}, {20, 185}, {200, 185}}), random);
  const std::optional<Edge> clearest = find_edge(seen.profile());
  REQUIRE(clearest);
  CHECK(clearest->kind == EdgeKind::step);
  CHECK(clearest->y == Approx(20).margin(0.6));
  CHECK(clearest->z == Approx(185).margin(0.1));
  EdgeOptions options;
  options.expected = -22;
  const std::optional<Edge> expected = find_edge(seen.profile(), options);
  REQUIRE(expected);
  CHECK(expected->y == Approx(-25).margin(0.6));
  CHECK(expected->z == Approx(205).margin(0.1));
}

TEST_CASE("edge: spikes and gaps beside it do not move it", "[edge]") {
  std::mt19937 random(8);
  Scan seen = scan(crease(-5, 200, 0, 40), random);
  for (const std::size_t i : {70U, 90U, 101U, 140U, 150U}) seen.z[i] += 15;
  for (std::size_t i = 80; i < 86; ++i) seen.valid[i] = false;
  const std::optional<Edge> edge = find_edge(seen.profile());
  REQUIRE(edge);
  CHECK(edge->y == Approx(-5).margin(0.5));
  CHECK(edge->z == Approx(200).margin(0.3));
}

}  // namespace
}  // namespace pal::skills::sensing
