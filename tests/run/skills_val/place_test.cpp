// Place at Location: each way in which it ends.
#include <catch2/catch.hpp>

#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/workshop.hpp"

using namespace pal;
using namespace pal::test;
using Eigen::Vector3d;

TEST_CASE("place-at-location: 0, the part stands at its place, the fingers above it") {
  Workshop shop(scene("parts"));
  const Vector3d before = shop.middle("part");
  REQUIRE(shop.run("pick-at-location").code == 0);
  const auto outcome = shop.run("place-at-location");
  CHECK(end_of(outcome) == "place-at-location 0");
  CHECK_FALSE(outcome.fault);
  CHECK((shop.middle("part") - before - (shop.location("PLACE") - shop.location("PART"))).norm() < 0.3);
  CHECK(shop.cell().workcell().gripper_width() == Approx(80).margin(0.5));
  CHECK((shop.tip() - shop.location("PLACE") - Vector3d(0, 0, 50)).norm() < 0.2);
}

TEST_CASE("place-at-location: 2, the part falls on the way there, it does not say that it put it down") {
  Workshop shop(scene("parts"));
  REQUIRE(shop.run("pick-at-location").code == 0);
  // Someone opens the fingers while the arm carries the part.
  shop.cell().station().timeline().after(std::chrono::milliseconds(800),
                                         [&] { shop.cell().workcell().gripper_open(); });
  const auto outcome = shop.run("place-at-location");
  CHECK(end_of(outcome) == "place-at-location 2");
  CHECK(outcome.reason.find("the part slipped out of the fingers on the way") != std::string::npos);
  CHECK_FALSE(shop.cell().workcell().holds_part());
}

TEST_CASE(
    "place-at-location: a heavy part is weighed, and its weight is not taken for a place that is taken") {
  const ChangedScene heavy("heavy-part", "part at 460 -200 mass 3000");
  Workshop shop(heavy.scene());
  REQUIRE(shop.run("pick-at-location").code == 0);
  CHECK(shop.run("place-at-location").code == 0);
  CHECK((shop.middle("part") - shop.location("PLACE")).head<2>().norm() < 0.5);
}

TEST_CASE("place-at-location: 1, nothing held, and nothing moves") {
  Workshop shop(scene("parts"));
  const Vector3d before = shop.tip();
  const auto outcome = shop.run("place-at-location");
  CHECK(end_of(outcome) == "place-at-location 1");
  CHECK_FALSE(outcome.fault);
  CHECK((shop.tip() - before).norm() < 0.1);
}

TEST_CASE("place-at-location: 1, the place is taken: the part is held above it again") {
  Workshop shop(scene("pallet"));
  REQUIRE(
      shop.run("pick-at-location", {text("location", "PART1"), {.name = "approach", .value = 100}}).code ==
      0);
  const Vector3d taken = shop.middle("part 2");
  const auto outcome =
      shop.run("place-at-location", {text("location", "PART2"), {.name = "approach", .value = 100}});
  CHECK(end_of(outcome) == "place-at-location 1");
  CHECK_FALSE(outcome.fault);
  CHECK_FALSE(shop.cell().workcell().fault().has_value());
  CHECK(shop.cell().workcell().holds_part());
  CHECK((shop.tip() - shop.location("PART2") - Vector3d(0, 0, 100)).norm() < 0.2);
  CHECK((shop.middle("part 2") - taken).norm() < 1);  // what stands there stays there
}

// Why the skill feels on its way down: the fingers come to grip both blocks.
TEST_CASE("place-at-location: without feeling, what stands at the place is lifted, too") {
  Workshop shop(scene("pallet"));
  REQUIRE(
      shop.run("pick-at-location", {text("location", "PART1"), {.name = "approach", .value = 100}}).code ==
      0);
  const Vector3d taken = shop.middle("part 2");
  const auto outcome =
      shop.run("place-at-location",
               {text("location", "PART2"), {.name = "approach", .value = 100}, {.name = "feel", .value = 0}});
  CHECK(end_of(outcome) == "place-at-location 1");
  CHECK((shop.middle("part 2") - taken).norm() > 50);
}

TEST_CASE(
    "place-at-location: 1, a post at the place, met without feeling: the arm is freed and back above it") {
  const ChangedScene changed("parts", "post at 460 -50 height 40\nlocation TAKEN 460 -50 -156.8");
  Workshop shop(changed.scene());
  REQUIRE(shop.run("pick-at-location", {{.name = "approach", .value = 100}}).code == 0);
  const auto outcome =
      shop.run("place-at-location",
               {text("location", "TAKEN"), {.name = "approach", .value = 100}, {.name = "feel", .value = 0}});
  CHECK(end_of(outcome) == "place-at-location 1");
  CHECK_FALSE(shop.cell().workcell().fault().has_value());
  CHECK((shop.tip() - shop.location("TAKEN") - Vector3d(0, 0, 100)).norm() < 0.2);
}

TEST_CASE("place-at-location: 2, a post on the way there, the arm stands still") {
  const ChangedScene changed("parts", "post at 460 -50 height 120");
  Workshop shop(changed.scene());
  REQUIRE(shop.run("pick-at-location").code == 0);
  CHECK(end_of(shop.run("place-at-location")) == "place-at-location 2");
  CHECK(shop.cell().workcell().fault().has_value());
  CHECK(shop.tip().y() < 0);
}

TEST_CASE("place-at-location: 2, a location that was never taught, the part stays in the fingers") {
  Workshop shop(scene("parts"));
  REQUIRE(shop.run("pick-at-location").code == 0);
  const auto outcome = shop.run("place-at-location", {text("location", "NOWHERE")});
  CHECK(end_of(outcome) == "place-at-location 2");
  CHECK(outcome.reason.find("Undefined value NOWHERE") != std::string::npos);
  CHECK(shop.cell().workcell().holds_part());
}
