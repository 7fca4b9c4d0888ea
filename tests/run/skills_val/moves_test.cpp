// Move to Location, Move Cartesian and Relative Move: each way in which they end.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "tests/run/skills/support/physical_run.hpp"
#include "tests/run/skills/support/workshop.hpp"

using namespace pal;
using namespace pal::test;
using Eigen::Vector3d;

namespace {

constexpr double near = 0.15;  // mm: the joints' play, and what the servos leave

bool stands(Workshop& shop, const Vector3d& where) {
  return (shop.tip() - where).norm() < near && shop.cell().workcell().idle();
}

Vector3d axis_z(Workshop& shop) {
  return shop.cell().workcell().tool().rotation().col(2);
}

}  // namespace

TEST_CASE("move-to-location: 0, with all joints together and in a straight line") {
  const bool straight = GENERATE(false, true);
  Workshop shop(scene("parts"));
  const auto outcome = shop.run(
      "move-to-location", {text("location", "PLACE"), {.name = "straight", .value = straight ? 1.0 : 0.0}});
  CHECK(end_of(outcome) == "move-to-location 0");
  CHECK_FALSE(outcome.fault);
  CHECK(stands(shop, shop.location("PLACE")));
  const Vector3d begin = 1e3 * shop.log().front().tool, way = (shop.location("PLACE") - begin).normalized();
  double off = 0;
  for (const sim::Sample& sample : shop.log())
    off = std::max(off, (1e3 * sample.tool - begin).cross(way).norm());
  CHECK((off < 0.2) == straight);
}

TEST_CASE("move-to-location: slower takes longer") {
  runtime::Time fast{}, slow{};
  for (const auto& [speed, time] : {std::pair(100.0, &fast), std::pair(5.0, &slow)}) {
    Workshop shop(scene("parts"));
    const auto outcome =
        shop.run("move-to-location", {text("location", "PLACE"), {.name = "speed", .value = speed}});
    CHECK(end_of(outcome) == "move-to-location 0");
    *time = outcome.duration;
  }
  CHECK(slow > 2 * fast);
}

TEST_CASE("move-to-location: 1, beyond the arm's reach, and nothing moves") {
  Workshop shop(scene("parts"));
  sim::Pose far = shop.cell().val_store().locations.at("HOME");
  far.translation().x() = 1.5;
  shop.cell().val_store().locations["FAR"] = far;
  const Vector3d before = shop.tip();
  const auto outcome = shop.run("move-to-location", {text("location", "FAR")});
  CHECK(end_of(outcome) == "move-to-location 1");
  CHECK_FALSE(outcome.fault);
  CHECK(stands(shop, before));
}

TEST_CASE("move-to-location: 2, a location that was never taught") {
  Workshop shop(scene("parts"));
  const Vector3d before = shop.tip();
  const auto outcome = shop.run("move-to-location", {text("location", "NOWHERE")});
  CHECK(end_of(outcome) == "move-to-location 2");
  CHECK(outcome.reason.find("VAL: Undefined value NOWHERE") != std::string::npos);
  CHECK(stands(shop, before));
}

TEST_CASE("move-to-location: 2, a post in the way") {
  Workshop shop(scene("posts"));
  const auto outcome =
      shop.run("move-to-location", {text("location", "BEYOND"), {.name = "straight", .value = 1}});
  CHECK(end_of(outcome) == "move-to-location 2");
  CHECK(shop.cell().workcell().fault().has_value());
  CHECK((shop.tip() - shop.location("BEYOND")).norm() > 50);
  const Vector3d stopped = shop.tip();
  shop.cell().rest(std::chrono::milliseconds(500));
  CHECK(stands(shop, stopped));
}

TEST_CASE(
    "move-to-location: 2, the line to VAL breaks, the motion under way is ended, as nothing can stop it") {
  Workshop shop(scene("parts"));
  const auto& lines = shop.cell().lines();
  const auto val =
      std::find_if(lines.begin(), lines.end(), [](const auto& line) { return line.device == "val"; });
  REQUIRE(val != lines.end());
  shop.cell().station().timeline().after(std::chrono::milliseconds(500),
                                         [&] { val->wire->cut("a rat has bitten through it"); });
  const auto outcome = shop.run("move-to-location", {text("location", "PLACE")});
  CHECK(end_of(outcome) == "move-to-location 2");
  CAPTURE(outcome.reason);
  CHECK(outcome.reason.find("VAL: line to VAL broken") != std::string::npos);
  CHECK(stands(shop, shop.location("PLACE")));
}

TEST_CASE("move-cartesian: 0, at the pose, in a straight line past the posts") {
  Workshop shop(scene("posts"));
  const auto outcome = shop.run("move-cartesian", {{.name = "x", .value = 520},
                                                   {.name = "y", .value = -330},
                                                   {.name = "z", .value = -30},
                                                   {.name = "o", .value = -60},
                                                   {.name = "speed", .value = 250}});
  CHECK(end_of(outcome) == "move-cartesian 0");
  CHECK(stands(shop, {520, -330, -30}));
  CHECK(axis_z(shop).z() == Approx(-1).margin(1e-4));
}

TEST_CASE("move-cartesian: 1, out of reach and through a singular pose, nothing moves") {
  struct Way {
    double x, y, z, o, a;
    const char* what;
  };
  const Way way = GENERATE(Way{900, -200, 0, -90, 90, "out of reach"},
                           Way{-460, 200, 0, -90, 90, "through the shoulder's axis"},
                           Way{460, -200, 0, -90, -90, "a turn that the wrist cannot make on the way"});
  INFO(way.what);
  Workshop shop(scene("nothing"));
  const Vector3d before = shop.tip();
  const auto outcome = shop.run("move-cartesian", {{.name = "x", .value = way.x},
                                                   {.name = "y", .value = way.y},
                                                   {.name = "z", .value = way.z},
                                                   {.name = "o", .value = way.o},
                                                   {.name = "a", .value = way.a},
                                                   {.name = "speed", .value = 500}});
  CHECK(end_of(outcome) == "move-cartesian 1");
  CHECK_FALSE(outcome.fault);
  CHECK(stands(shop, before));
}

TEST_CASE("move-cartesian: 2, a post in the way") {
  Workshop shop(scene("posts"));
  const auto outcome =
      shop.run("move-cartesian",
               {{.name = "x", .value = 480}, {.name = "y", .value = -30}, {.name = "z", .value = -60}});
  CHECK(end_of(outcome) == "move-cartesian 2");
  CHECK(shop.cell().workcell().fault().has_value());
}

TEST_CASE("moves: a parameter out of range is refused before anything moves") {
  Workshop shop(scene("nothing"));
  const Vector3d before = shop.tip();
  const auto outcome = shop.run("move-cartesian", {{.name = "speed", .value = 501}});
  CHECK(outcome.fault);
  CHECK(outcome.reason.find("speed") != std::string::npos);
  CHECK(shop.run("relative-move", {{.name = "dx", .value = -301}}).fault);
  CHECK(shop.run("move-to-location", {{.name = "speed", .value = 0.5}}).fault);
  CHECK(stands(shop, before));
}

TEST_CASE("relative-move: 0, moved and turned in the tool's own frame") {
  Workshop shop(scene("nothing"));
  const sim::Pose before = shop.cell().workcell().tool();
  const auto outcome = shop.run("relative-move", {{.name = "dx", .value = 40},
                                                  {.name = "dy", .value = -30},
                                                  {.name = "dz", .value = -50},
                                                  {.name = "rx", .value = 10},
                                                  {.name = "ry", .value = 20},
                                                  {.name = "rz", .value = 30}});
  CHECK(end_of(outcome) == "relative-move 0");
  constexpr double degree = std::numbers::pi / 180;
  const sim::Pose expected = before * Eigen::Translation3d(0.040, -0.030, -0.050) *
                             Eigen::Isometry3d(Eigen::AngleAxisd(30 * degree, Vector3d::UnitZ()) *
                                               Eigen::AngleAxisd(20 * degree, Vector3d::UnitY()) *
                                               Eigen::AngleAxisd(10 * degree, Vector3d::UnitX()));
  CHECK(stands(shop, 1e3 * expected.translation()));
  const sim::Pose after = shop.cell().workcell().tool();
  CHECK(Eigen::AngleAxisd(expected.rotation().transpose() * after.rotation()).angle() < 0.05 * degree);
}

TEST_CASE("relative-move: 1, beyond the arm's reach, and nothing moves") {
  Workshop shop(scene("nothing"));
  REQUIRE(shop.run("move-cartesian", {{.name = "x", .value = 700}}).code == 0);
  const Vector3d before = shop.tip();
  CHECK(end_of(shop.run("relative-move", {{.name = "dx", .value = 300}})) == "relative-move 1");
  CHECK(stands(shop, before));
}

TEST_CASE("relative-move: 1, to where the wrist is stretched, a singular pose, nothing moves") {
  Workshop shop(scene("nothing"));
  const Vector3d before = shop.tip();
  CHECK(shop.run("relative-move", {{.name = "ry", .value = -20}, {.name = "rz", .value = 1}}).code == 1);
  CHECK(stands(shop, before));
}

TEST_CASE("relative-move: 2, the table in the way") {
  Workshop shop(scene("parts"));
  const auto outcome = shop.run("relative-move", {{.name = "dz", .value = 150}});  // 122 mm above the table
  CHECK(end_of(outcome) == "relative-move 2");
  CHECK(shop.cell().workcell().fault().has_value());
}
