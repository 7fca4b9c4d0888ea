// The skills that talk VAL: each way in which they end.
#include <catch2/catch.hpp>

#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/skill_cell.hpp"

using namespace pal;
using namespace pal::test;

namespace {

constexpr double grasp_height = -156.8;  // mm: the middle of a block of 50 mm on the table

double off(const Eigen::Vector3d& where, double x, double y, double z) {
  return (where - Eigen::Vector3d(x, y, z)).norm();
}

}  // namespace

TEST_CASE("move-to-location: there, out of reach, unknown") {
  SkillCell cell("parts");
  cell.teach("HOME", 500, -100, 50);
  cell.teach("FAR", 1500, 0, 0);
  const double straight = GENERATE(0.0, 1.0);
  CHECK(cell.run("move-to-location", {{"straight", straight}, {"speed", 100}}).code == 0);
  CHECK(off(cell.tip(), 500, -100, 50) < 0.3);
  CHECK(cell.run("move-to-location", {text("location", "FAR")}).code == 1);
  CHECK(off(cell.tip(), 500, -100, 50) < 0.3);
  CHECK(cell.run("move-to-location", {text("location", "NOWHERE")}).code == 2);
}

TEST_CASE("move-cartesian: there, and out of reach") {
  SkillCell cell("flat");
  CHECK(cell.run("move-cartesian", {{"x", 450}, {"y", -150}, {"z", 60}, {"speed", 200}}).code == 0);
  CHECK(off(cell.tip(), 450, -150, 60) < 0.3);
  CHECK(cell.run("move-cartesian", {{"x", 900}, {"y", 0}, {"z", 0}}).code == 1);
  CHECK(off(cell.tip(), 450, -150, 60) < 0.3);
}

TEST_CASE("relative-move goes and turns in the frame of the tool") {
  SkillCell cell("flat");
  const sim::Pose before = cell.workcell().tool();
  REQUIRE(cell.run("relative-move", {{"dx", 20}, {"dy", -10}, {"dz", 15}, {"rx", 12}, {"ry", -8}, {"rz", 25}})
              .code == 0);
  const sim::Pose way = before.inverse() * cell.workcell().tool();
  CHECK(off(way.translation() * 1e3, 20, -10, 15) < 0.3);
  const double degree = 3.14159265358979 / 180;
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(25 * degree, Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(-8 * degree, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(12 * degree, Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  CHECK(Eigen::AngleAxisd(turn.transpose() * way.linear()).angle() / degree < 0.1);
  CHECK(cell.run("relative-move", {{"dx", 300}, {"dy", 300}, {"dz", -300}}).code == 1);
}

TEST_CASE("a part is picked, placed, and not found where it was") {
  SkillCell cell("parts");
  cell.teach("PART", 460, -200, grasp_height);
  cell.teach("PLACE", 460, -100, grasp_height);
  const auto picked = cell.run("pick-at-location");
  CAPTURE(picked.reason);
  REQUIRE(picked.code == 0);
  CHECK(cell.workcell().holds_part());
  CHECK(off(cell.tip(), 460, -200, grasp_height + 50) < 0.5);
  CHECK(cell.run("place-at-location").code == 0);
  CHECK_FALSE(cell.workcell().holds_part());
  CHECK(off(cell.tip(), 460, -100, grasp_height + 50) < 0.5);
  // Nothing is held any more, and nothing is where the part was.
  const Eigen::Vector3d stands = cell.tip();
  CHECK(cell.run("place-at-location").code == 1);
  CHECK((cell.tip() - stands).norm() < 0.1);
  CHECK(cell.run("pick-at-location").code == 1);
  CHECK(off(cell.tip(), 460, -200, grasp_height + 50) < 0.5);
  CHECK(cell.workcell().gripper_width() > 70);
}

TEST_CASE("pick and place end with an error where VAL does not know the location") {
  SkillCell cell("parts");
  CHECK(cell.run("pick-at-location", {text("location", "NOWHERE")}).code == 2);
  cell.teach("PART", 460, -200, grasp_height);
  REQUIRE(cell.run("pick-at-location").code == 0);
  CHECK(cell.run("place-at-location", {text("location", "NOWHERE")}).code == 2);
}

TEST_CASE("palletize: the next place, a full pallet, and nothing held") {
  SkillCell cell("parts");
  cell.teach("PART", 460, -200, grasp_height);
  cell.teach("CORNER", 400, -100, grasp_height);
  CHECK(cell.run("palletize").code == 2);  // nothing is held
  REQUIRE(cell.run("pick-at-location").code == 0);
  CHECK(cell.run("palletize", {{"rows", 2}, {"columns", 2}, {"placed", 4}}).code == 1);
  CHECK(cell.workcell().holds_part());
  CHECK(cell.run("palletize", {{"rows", 2}, {"columns", 2}, {"placed", 3}, {"pitch", 60}}).code == 0);
  CHECK(off(cell.tip(), 460, -40, grasp_height + 50) < 0.5);
  CHECK_FALSE(cell.workcell().holds_part());
}
