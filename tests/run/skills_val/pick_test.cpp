// Pick at Location: each way in which it ends.
#include <catch2/catch.hpp>

#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/workshop.hpp"

using namespace pal;
using namespace pal::test;
using Eigen::Vector3d;

TEST_CASE("pick-at-location: 0, the part hangs above its place") {
  Workshop shop(scene("parts"));
  const Vector3d before = shop.middle("part");
  const auto outcome = shop.run("pick-at-location", {{.name = "approach", .value = 80}});
  CHECK(end_of(outcome) == "pick-at-location 0");
  CHECK_FALSE(outcome.fault);
  CHECK(shop.cell().workcell().holds_part());
  CHECK((shop.tip() - shop.location("PART") - Vector3d(0, 0, 80)).norm() < 0.2);
  CHECK((shop.middle("part") - before - Vector3d(0, 0, 80)).norm() < 0.3);
}

TEST_CASE("pick-at-location: 0, without a pause between closing and lifting") {
  Workshop shop(scene("parts"));
  CHECK(shop.run("pick-at-location", {{.name = "grip-delay", .value = 0}}).code == 0);
  CHECK(shop.cell().workcell().holds_part());
}

TEST_CASE("pick-at-location: 1, nothing there: the fingers are open again, above the location") {
  Workshop shop(scene("empty-place"));
  const auto outcome = shop.run("pick-at-location", {{.name = "approach", .value = 80}});
  CHECK(end_of(outcome) == "pick-at-location 1");
  CHECK_FALSE(outcome.fault);
  CHECK(shop.cell().workcell().gripper_width() == Approx(80).margin(0.5));
  CHECK((shop.tip() - shop.location("PART") - Vector3d(0, 0, 80)).norm() < 0.2);
}

TEST_CASE(
    "pick-at-location: 3, too heavy a part slips out on the way up: the fingers are open, above the "
    "location") {
  const ChangedScene heavy("heavy-part", "part at 460 -200 mass 5000");
  Workshop shop(heavy.scene());
  const auto outcome = shop.run("pick-at-location");
  CHECK(end_of(outcome) == "pick-at-location 3");
  CHECK_FALSE(outcome.fault);
  CHECK_FALSE(shop.cell().workcell().holds_part());
  CHECK(shop.cell().workcell().gripper_width() == Approx(80).margin(0.5));
  CHECK((shop.tip() - shop.location("PART") - Vector3d(0, 0, 50)).norm() < 0.2);
}

TEST_CASE("pick-at-location: 2, a finger comes down on a part beside the location, which the reason names") {
  const ChangedScene beside("heavy-part", "part at 460 -160");
  Workshop shop(beside.scene());
  const auto outcome = shop.run("pick-at-location");
  CHECK(end_of(outcome) == "pick-at-location 2");
  CAPTURE(outcome.reason);
  CHECK(outcome.reason.find("finger presses on the part") != std::string::npos);
  // It has backed off.
  CHECK(shop.cell().workcell().log().back().contact_force == 0);
}

TEST_CASE("pick-at-location: 2, a location that was never taught") {
  Workshop shop(scene("parts"));
  const Vector3d before = shop.tip();
  const auto outcome = shop.run("pick-at-location", {text("location", "NOWHERE")});
  CHECK(end_of(outcome) == "pick-at-location 2");
  CHECK(outcome.reason.find("Undefined value NOWHERE") != std::string::npos);
  CHECK((shop.tip() - before).norm() < 0.1);
}

TEST_CASE("pick-at-location: 2, a location out of reach, the arm stands still") {
  Workshop shop(scene("parts"));
  sim::Pose far = shop.cell().val_store().locations.at("PART");
  far.translation().x() = 1.5;
  shop.cell().val_store().locations["FAR"] = far;
  const Vector3d before = shop.tip();
  const auto outcome = shop.run("pick-at-location", {text("location", "FAR")});
  CHECK(end_of(outcome) == "pick-at-location 2");
  CHECK((shop.tip() - before).norm() < 0.1);
  CHECK(shop.cell().workcell().idle());
}
