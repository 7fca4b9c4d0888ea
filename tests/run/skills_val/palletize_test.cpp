// Palletize: each way in which it ends.
#include <catch2/catch.hpp>

#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/workshop.hpp"

using namespace pal;
using namespace pal::test;
using Eigen::Vector3d;

TEST_CASE("palletize: 0, parts at the places that come next, row by row") {
  Workshop shop(scene("pallet"));
  const std::vector<std::pair<double, Vector3d>> places{
      {0, {0, 0, 0}}, {1, {90, 0, 0}}, {3, {0, 90, 0}}, {8, {180, 180, 0}}};
  int number = 0;
  for (const auto& [placed, offset] : places) {
    const std::string serial = std::to_string(++number);
    REQUIRE(
        shop.run("pick-at-location", {text("location", "PART" + serial), {.name = "approach", .value = 100}})
            .code == 0);
    const auto outcome = shop.run("palletize", {{.name = "placed", .value = placed}});
    CAPTURE(placed, outcome.reason);
    CHECK(end_of(outcome) == "palletize 0");
    CHECK_FALSE(outcome.fault);
  }
  number = 0;
  for (const auto& [placed, offset] : places) {
    INFO("after " << placed);
    CHECK((shop.middle("part " + std::to_string(++number)) - shop.location("CORNER") - offset).norm() < 0.3);
  }
  CHECK((shop.tip() - shop.location("CORNER") - Vector3d(180, 180, 100)).norm() < 0.2);
}

TEST_CASE("palletize: 1, the pallet is full, and nothing moves") {
  Workshop shop(scene("pallet"));
  REQUIRE(shop.run("pick-at-location", {text("location", "PART1")}).code == 0);
  const Vector3d before = shop.tip();
  const auto outcome = shop.run("palletize", {{.name = "rows", .value = 2}, {.name = "placed", .value = 6}});
  CHECK(end_of(outcome) == "palletize 1");
  CHECK_FALSE(outcome.fault);
  CHECK(shop.cell().workcell().holds_part());
  CHECK((shop.tip() - before).norm() < 0.1);
}

TEST_CASE("palletize: 2, nothing held, and nothing moves") {
  Workshop shop(scene("pallet"));
  const Vector3d before = shop.tip();
  const auto outcome = shop.run("palletize");
  CHECK(end_of(outcome) == "palletize 2");
  CHECK(outcome.reason.find("the fingers hold nothing") != std::string::npos);
  CHECK((shop.tip() - before).norm() < 0.1);
}

TEST_CASE("palletize: 3, the place is taken: the part is held above it again") {
  Workshop shop(scene("pallet"));
  REQUIRE(shop.run("pick-at-location", {text("location", "PART1")}).code == 0);
  REQUIRE(shop.run("palletize").code == 0);
  const Vector3d placed = shop.middle("part 1");
  REQUIRE(
      shop.run("pick-at-location", {text("location", "PART2"), {.name = "approach", .value = 100}}).code ==
      0);
  const auto outcome = shop.run("palletize");
  CAPTURE(outcome.reason);
  CHECK(end_of(outcome) == "palletize 3");
  CHECK_FALSE(outcome.fault);
  CHECK_FALSE(shop.cell().workcell().fault().has_value());
  CHECK(shop.cell().workcell().holds_part());
  CHECK((shop.tip() - shop.location("CORNER") - Vector3d(0, 0, 100)).norm() < 0.2);
  CHECK((shop.middle("part 1") - placed).norm() < 1);  // what stands there stays there
}
