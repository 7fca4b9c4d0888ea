// Where cameras stand: everything in the picture, the tool in sight.
#include "sim/picture/framing.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "sim/picture/camera.hpp"
#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;

namespace {

/// Where a point is in the picture: -1 to 1 from left to right and from the bottom to the top.
Eigen::Vector2d in_picture(const View& view, double aspect, const Eigen::Vector3d& point) {
  const Eigen::Vector3d from = point - view.eye();
  const double depth = from.dot(view.forward());
  REQUIRE(depth > 0);
  const double half = std::tan(view.opening * M_PI / 360);
  return {from.dot(view.right()) / depth / half / aspect, from.dot(view.up()) / depth / half};
}

}  // namespace

TEST_CASE("a framing has every point in the picture, and nothing to spare") {
  std::mt19937 chance(7);
  std::uniform_real_distribution<double> metres(-1, 1), degrees(-180, 180), tilt(-60, 10);
  for (int round = 0; round < 200; ++round) {
    const double aspect = 0.5 + 0.01 * round, margin = 0.1;
    Framing framing(degrees(chance), tilt(chance), 30, aspect, margin);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 12; ++i) {
      points.emplace_back(metres(chance), metres(chance), metres(chance));
      framing.include(points.back());
    }
    double widest = 0;
    for (const Eigen::Vector3d& point : points)
      widest = std::max(widest, in_picture(framing.view(), aspect, point).cwiseAbs().maxCoeff());
    CHECK(widest == Approx(1 - margin).epsilon(1e-9));
  }
}

TEST_CASE("cameras see the tool, and keep arm and table in the picture") {
  Workcell workcell(scene("touch"));
  Stage stage(workcell.physics().model());
  Snapshot snapshot = take_snapshot(workcell, {});
  constexpr double aspect = 1.2;
  for (const double turn : {0.0, 90.0, -90.0, 150.0}) {
    CAPTURE(turn);
    snapshot.positions[0] = turn * M_PI / 180;
    stage.show(snapshot);
    WorkcellCamera camera(stage, aspect, "");
    const View view = camera.view(stage, 0);
    // Nothing but the tool between the eye and the tool.
    const Eigen::Vector3d shank = stage.tip() + Eigen::Vector3d(0, 0, 0.03);
    const Eigen::Vector3d ray = (shank - view.eye()).normalized();
    int hit = -1;
    mj_ray(&stage.model(), &stage.data(), view.eye().data(), ray.data(), nullptr, 1, -1, &hit);
    REQUIRE(hit >= 0);
    CHECK(stage.of_tool(stage.model().geom_bodyid[hit]));
    for (int body = 1; body < stage.model().nbody; ++body) {
      const Eigen::Map<const Eigen::Vector3d> place(stage.data().xpos + 3 * body);
      CHECK(in_picture(view, aspect, place).cwiseAbs().maxCoeff() < 1);
    }
    const View near = ContactCamera(stage).view(stage, 0);
    CHECK(in_picture(near, 1, stage.tip()).cwiseAbs().maxCoeff() < 0.5);
  }
}

TEST_CASE("the close-up shows tip and surface, and moves without a jump") {
  Workcell workcell(scene("pyramid"));
  Stage stage(workcell.physics().model());
  Snapshot snapshot = take_snapshot(workcell, {});
  stage.show(snapshot);
  const auto ahead = workcell.cast(workcell.tool().translation(), workcell.tool().linear().col(2));
  REQUIRE(ahead);
  REQUIRE(*ahead > 0.1);
  ContactCamera camera(stage);
  const View both = camera.view(stage, 0.9);
  const Eigen::Vector3d surface = stage.tip() + *ahead * stage.pointing();
  CHECK(in_picture(both, 1, stage.tip()).cwiseAbs().maxCoeff() < 0.8);
  CHECK(in_picture(both, 1, surface).cwiseAbs().maxCoeff() < 0.8);
  snapshot.positions[1] += 0.5;  // up, and away from any surface
  stage.show(snapshot);
  const double first = camera.view(stage, 0.9).distance;
  double last = first;
  for (int i = 0; i < 100; ++i) last = camera.view(stage, 0.9).distance;
  CHECK(first > 0.85 * both.distance);
  CHECK(last < 0.6 * both.distance);
}

TEST_CASE("a camera that has been drawn back does not come nearer again") {
  Workcell workcell(scene("nothing"));
  Stage stage(workcell.physics().model());
  Snapshot snapshot = take_snapshot(workcell, {});
  stage.show(snapshot);
  WorkcellCamera camera(stage, 1.2, "");
  const View before = camera.view(stage, 0);
  snapshot.positions[1] += 0.8;  // the arm goes up
  stage.show(snapshot);
  const View raised = camera.view(stage, 0);
  snapshot.positions[1] -= 0.8;
  stage.show(snapshot);
  const View after = camera.view(stage, 0);
  CHECK((raised.eye() - before.eye()).dot(before.forward()) < -0.01);
  CHECK((after.eye() - raised.eye()).norm() == Approx(0).margin(1e-12));
}
