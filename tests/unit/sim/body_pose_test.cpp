#include "sim/picture/body_pose.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;

TEST_CASE("a view elsewhere gets the shapes once and the poses each frame") {
  Workcell workcell(scene("touch"));
  const SceneGeometry geometry = scene_geometry(workcell);
  const std::vector<BodyPose> poses = body_poses(workcell);
  REQUIRE(geometry.bodies.size() == poses.size() + 1);
  CHECK(poses.size() * sizeof(BodyPose) <= 28 * 16);
  CHECK(geometry.shapes.size() * sizeof(BodyShape) < 5000);

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

  bool orange_ball = false;
  for (const BodyShape& shape : geometry.shapes) {
    CHECK(shape.body < geometry.bodies.size());
    CHECK(shape.colour[3] > 0);
    orange_ball = orange_ball ||
                  (shape.kind == ShapeKind::sphere && shape.size[0] == 0.0085F && shape.colour[0] > 0.8F);
  }
  CHECK(orange_ball);
}
