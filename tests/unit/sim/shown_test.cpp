// What pictures and plots show: the range finder's fan, the seam, the place of a collision, the grip.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/picture/body_pose.hpp"
#include "sim/picture/camera.hpp"
#include "sim/picture/laser.hpp"
#include "sim/picture/picture.hpp"
#include "sim/picture/snapshot.hpp"
#include "sim/report/sample_spool.hpp"
#include "tests/unit/sim/scene_text.hpp"
#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;
using namespace std::chrono_literals;

TEST_CASE("shown: the range finder's fan meets what its rays meet") {
  Workcell workcell(scene("flat"));
  Stage stage(workcell.physics().model());
  stage.show(take_snapshot(workcell, {}));
  CHECK(stage.tool() == ToolKind::range_finder);
  const Laser laser = laser_of(stage);
  REQUIRE(laser.points.size() > 200);
  const auto straight = workcell.cast(workcell.tool().translation(), workcell.tool().linear().col(2));
  REQUIRE(straight);
  CHECK(laser.nearest().value() == Approx(1e3 * *straight).margin(0.5));
  // A line on the surface, and beams down to it.
  CHECK(marks_of(laser, stage).size() > laser.points.size() - 10);
  for (const Laser::Point& point : laser.points) CHECK(std::abs(point.across) < std::tan(0.36) * point.away);
}

TEST_CASE("shown: a surface has a line along its seam, which neither rays nor the tool meet") {
  Workcell workcell(scene("seam"));
  const SceneGeometry geometry = scene_geometry(workcell);
  const auto capsules = std::count_if(
      geometry.shapes.begin(), geometry.shapes.end(),
      [](const BodyShape& shape) { return shape.kind == ShapeKind::capsule && shape.size[0] < 0.001F; });
  CHECK(capsules >= 50);
  const mjModel& model = workcell.physics().model();
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.geom_type[geom] != mjGEOM_CAPSULE || model.geom_size[3 * geom] > 0.001) continue;
    CHECK(model.geom_contype[geom] == 0);
    CHECK(model.geom_conaffinity[geom] == 0);
    CHECK(model.geom_group[geom] == 1);  // of which no ray takes notice
  }
}

TEST_CASE("shown: a collision has its place, and the close-up looks there") {
  Workcell workcell(scene("bar-under-forearm"));
  for (pal::runtime::Time begin{}; !workcell.fault() && begin < 8s; begin += alter_period) {
    workcell.move({0, 0, 0.56, 0, 0, 0}, CorrectionFrame::tool, begin);
    workcell.advance_to(begin + alter_period);
  }
  REQUIRE(workcell.fault());
  REQUIRE(workcell.fault()->place);
  const Snapshot snapshot = take_snapshot(workcell, {});
  CHECK(snapshot.fault == "the forearm hit the bar");
  Stage stage(workcell.physics().model());
  stage.show(snapshot);
  const Eigen::Vector3d place = stage.in_world(snapshot.hit.value());
  // At the bar, whose name is the body's.
  const int bar = mj_name2id(&stage.model(), mjOBJ_BODY, "bar");
  const Eigen::Map<const Eigen::Vector3d> middle(stage.data().xpos + 3 * bar);
  CHECK(std::hypot(place.y() - middle.y(), place.z() - middle.z()) < 0.05);
  ContactCamera camera(stage);
  const View view = camera.view_of_place(stage, place);
  CHECK((view.target - place).norm() < 1e-9);
  // Nothing but the two that met is before it.
  const Eigen::Vector3d eye = view.eye(), ray = (place - eye).normalized();
  int hit = -1;
  const double met = mj_ray(&stage.model(), &stage.data(), eye.data(), ray.data(), nullptr, 1, -1, &hit);
  CHECK((place - eye).norm() - met < 0.06);
}

TEST_CASE("shown: a grip is no contact force") {
  const SceneText around("tool gripper\nstart 460 -200 -156.8\npart at 460 -200\n");
  Workcell workcell(around.scene());
  workcell.gripper_close();
  workcell.advance_to(1500ms);
  const Sample& sample = workcell.log().back();
  CHECK(sample.grip_force > 10);
  CHECK(sample.contact_force == 0);
  CHECK(shown_force(ToolKind::gripper, sample) == sample.grip_force);
  CHECK(shown_force(ToolKind::pad, sample) == sample.contact_force);
}

TEST_CASE("shown: samples on the disk come back, and few of them keep every peak") {
  SampleSpool spool;
  Workcell workcell(scene("touch"));
  workcell.advance_to(50ms);
  Sample sample = workcell.log().back();
  for (int i = 0; i < 20'000; ++i) {
    sample.time = std::chrono::milliseconds(i);
    sample.contact_force = i == 12'345 ? 17 : 1;
    sample.grip_force = i == 777 ? 9 : 0;
    spool.append(sample);
  }
  const std::vector<Sample> all = spool.telling(20'000);
  REQUIRE(all.size() == 20'000);
  CHECK(all.back().joints == sample.joints);
  CHECK(all.back().tool_turn.coeffs() == sample.tool_turn.coeffs());
  CHECK(all.back().wrench.torque == sample.wrench.torque);
  CHECK(all[12'345].contact_force == 17);
  const std::vector<Sample> some = spool.telling(1000);
  CHECK(some.size() < 1000);
  CHECK(std::any_of(some.begin(), some.end(), [](const Sample& one) { return one.contact_force == 17; }));
  CHECK(std::any_of(some.begin(), some.end(), [](const Sample& one) { return one.grip_force == 9; }));
  CHECK(std::is_sorted(some.begin(), some.end(),
                       [](const Sample& one, const Sample& other) { return one.time < other.time; }));
}
