#include "sim/picture/body_pose.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;
namespace runtime = pal::runtime;

TEST_CASE("a view elsewhere gets the shapes once and the poses each frame") {
  Workcell workcell(scene("touch"));
  const SceneGeometry geometry = scene_geometry(workcell);
  const std::vector<BodyPose> poses = body_poses(workcell);
  REQUIRE(geometry.bodies.size() == poses.size() + 1);
  CHECK(poses.size() * sizeof(BodyPose) <= 28 * 16);
  // Without the room for meshes, of which this scene has none.
  constexpr std::size_t plain = sizeof(BodyShape) - sizeof(BodyShape::corners) - sizeof(BodyShape::triangles);
  CHECK(geometry.shapes.size() * plain < 5000);

  std::size_t sensors = 0;
  for (std::size_t i = 0; i < geometry.bodies.size(); ++i) {
    if (geometry.bodies[i] != "tool") continue;
    // The tool points down: its z axis turned by the body's quaternion.
    const auto& [w, x, y, z] = poses[i - 1].turn;
    const Eigen::Vector3d axis = Eigen::Quaterniond(w, x, y, z) * Eigen::Vector3d::UnitZ();
    CHECK((axis - Eigen::Vector3d(0, 0, -1)).norm() < 1e-3);
    // 60 mm above the tip, which is given in frame 0.
    const auto& [px, py, pz] = poses[i - 1].position;
    const Eigen::Vector3d tip = workcell.tool().translation();
    CHECK((Eigen::Vector3d(px, py, pz) - Eigen::Vector3d(tip.x(), tip.y(), tip.z() + 0.6718 + 0.060)).norm() <
          1e-4);
    ++sensors;
  }
  CHECK(sensors == 1);

  // The floor's world and the table stand still; all from the first link on moves.
  REQUIRE(geometry.moves.size() == geometry.bodies.size());
  for (std::size_t i = 0; i < geometry.bodies.size(); ++i)
    CHECK(geometry.moves[i] == (geometry.bodies[i].rfind("link", 0) == 0 || geometry.bodies[i] == "sensor" ||
                                geometry.bodies[i] == "tool" || geometry.bodies[i] == "pad"));
  CHECK(geometry.bodies.at(geometry.tip.body) == "tool");
  CHECK(geometry.tip.position[2] == Approx(0.060));
  CHECK(geometry.bodies.at(geometry.base.body) == "base");

  bool orange_ball = false;
  for (const BodyShape& shape : geometry.shapes) {
    CHECK(shape.body < geometry.bodies.size());
    CHECK(shape.colour[3] > 0);
    orange_ball = orange_ball ||
                  (shape.kind == ShapeKind::sphere && shape.size[0] == 0.0085F && shape.colour[0] > 0.8F);
  }
  CHECK(orange_ball);
}

TEST_CASE("a view elsewhere sees where the tool presses, and the force on it points off the surface") {
  Workcell workcell(scene("touch"));
  CHECK(contact_points(workcell).empty());
  const auto presses = [&] { return !workcell.log().empty() && workcell.log().back().contact_force >= 5; };
  for (runtime::Time begin{}; !presses() && begin < 8s; begin += alter_period) {
    workcell.move({0, 0, 0.4, 0, 0, 0}, CorrectionFrame::tool, begin);
    workcell.advance_to(begin + alter_period);
  }
  const std::vector<ContactPoint> points = contact_points(workcell);
  REQUIRE_FALSE(points.empty());
  double up = 0;
  for (const ContactPoint& each : points) {
    up += each.force[2];
    // At the tip, which is given in frame 0.
    const Eigen::Vector3d tip = workcell.tool().translation();
    CHECK(each.position[0] == Approx(tip.x()).margin(0.01));
    CHECK(each.position[2] == Approx(tip.z() + 0.6718).margin(0.01));
  }
  CHECK(up == Approx(workcell.log().back().contact_force).epsilon(0.05));
}

TEST_CASE("a view elsewhere gets a surface of heights as triangles") {
  Workcell workcell(scene("waves"));
  const SceneGeometry geometry = scene_geometry(workcell);
  const auto surface = std::find_if(geometry.shapes.begin(), geometry.shapes.end(),
                                    [](const BodyShape& shape) { return !shape.triangles.empty(); });
  REQUIRE(surface != geometry.shapes.end());
  CHECK(surface->kind == ShapeKind::mesh);
  CHECK(surface->corners.size() <= 3 * 64 * 64);
  const std::size_t corners = surface->corners.size() / 3;
  for (const std::uint32_t corner : surface->triangles) CHECK(corner < corners);
  float low = 1, high = -1;
  for (std::size_t i = 0; i < corners; ++i) {
    low = std::min(low, surface->corners[3 * i + 2]);
    high = std::max(high, surface->corners[3 * i + 2]);
  }
  CHECK(high - low > 0.0005F);
}
