// What stops the arm by itself, and what the words for it are.
#include <algorithm>
#include <catch2/catch.hpp>
#include <utility>

#include "tests/unit/sim/scene_text.hpp"
#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;

namespace {

// Moves on evenly until the arm refuses; the answer is the refusal.
std::string move_until_refused(Workcell& workcell, const Correction& correction, CorrectionFrame frame,
                               int most) {
  for (int i = 0; i < most; ++i) {
    if (const auto refused = workcell.move(correction, frame, workcell.now())) return *refused;
    workcell.advance_to(workcell.now() + alter_period);
  }
  return "";
}

}  // namespace

TEST_CASE("faults: a bar under the forearm stops the arm, which names both") {
  Workcell workcell(scene("bar-under-forearm"));
  std::vector<std::string> told;
  const auto listening = workcell.on_fault([&](const ArmFault& fault) {
    told.push_back(fault.text);
    CHECK(fault.time == workcell.now());
  });
  const std::string refused = move_until_refused(workcell, {0, 0, 0.56, 0, 0, 0}, CorrectionFrame::tool, 200);
  REQUIRE(workcell.fault());
  CHECK(workcell.fault()->kind == ArmFault::Kind::collision);
  CHECK(workcell.fault()->text == "the forearm hit the bar");
  CHECK(refused == "the arm has stopped: the forearm hit the bar");
  CHECK(told == std::vector<std::string>{"the forearm hit the bar"});
  CHECK(workcell.log().back().contact_force == 0);  // the tool has not come to the plate

  // It backs off a little, the way that it came, stands, and says nothing new.
  const Eigen::Vector3d there = workcell.tool().translation();
  workcell.advance_to(workcell.now() + 500ms);
  const Eigen::Vector3d back = workcell.tool().translation() - there;
  CHECK(back.z() > 8e-3);
  CHECK(back.norm() < 11e-3);
  const Eigen::Vector3d stands = workcell.tool().translation();
  workcell.advance_to(workcell.now() + 500ms);
  CHECK((workcell.tool().translation() - stands).norm() < 1e-4);
  CHECK(told.size() == 1);

  // Reset, it may be moved away from what it hit, and a second meeting is a fault again.
  workcell.reset_fault();
  CHECK(move_until_refused(workcell, {0, 0, -0.56, 0, 0, 0}, CorrectionFrame::tool, 10).empty());
  CHECK_FALSE(workcell.fault());
  CHECK_FALSE(move_until_refused(workcell, {0, 0, 0.56, 0, 0, 0}, CorrectionFrame::tool, 60).empty());
  CHECK(told.size() == 2);
}

TEST_CASE("faults: an arm that has hit something backs off, and does not go on pressing on it") {
  // Steel fingers on a steel plate: the drives give all they have until the arm is found not to follow.
  const SceneText text("tool gripper\nstart 480 -200 -140\nplate at 480 -200\n");
  Workcell workcell(text.scene());
  move_until_refused(workcell, {0, 0, 1, 0, 0, 0}, CorrectionFrame::tool, 120);
  REQUIRE(workcell.fault());
  double peak = 0;
  for (const Sample& sample : workcell.log()) peak = std::max(peak, sample.contact_force);
  CHECK(peak > 100);
  workcell.advance_to(workcell.now() + 500ms);
  CAPTURE(peak);
  CHECK(workcell.log().back().contact_force == 0);
  const Eigen::Vector3d there = workcell.tool().translation();
  workcell.advance_to(workcell.now() + 1s);
  CHECK((workcell.tool().translation() - there).norm() < 1e-4);  // and it does not sink
}

TEST_CASE("faults: an arm that has hit something from aside backs off, too") {
  // Gears that turn hard hold much more in some directions than in others.
  const auto [scene_of_test, motion] =
      GENERATE(std::pair("tool gripper\nstart 460 -200 -120\nblock at 570 -200 size 40 300 200\n",
                         Correction{1.5, 0, 0, 0, 0, 0}),
               std::pair("tool gripper\nstart 460 -200 -120\nblock at 350 -200 size 40 300 200\n",
                         Correction{-1.5, 0, 0, 0, 0, 0}),
               std::pair("tool gripper\nstart 460 -200 -120\nblock at 460 -90 size 300 40 200\n",
                         Correction{0, 1.5, 0, 0, 0, 0}));
  const SceneText text(scene_of_test);
  Workcell workcell(text.scene());
  move_until_refused(workcell, motion, CorrectionFrame::world, 120);
  REQUIRE(workcell.fault());
  CAPTURE(workcell.fault()->text);
  workcell.advance_to(workcell.now() + 500ms);
  CHECK(workcell.log().back().contact_force == 0);
}

TEST_CASE("faults: backing off ends where the way began, and after a reset the arm stands where it is") {
  // A millimetre above the plate: there is not more of a way to go back.
  const SceneText text("tool range-finder\nstart 480 -200 -165.8\nplate at 480 -200\n");
  Workcell workcell(text.scene());
  const Eigen::Vector3d began = workcell.tool().translation();
  move_until_refused(workcell, {0, 0, 1, 0, 0, 0}, CorrectionFrame::tool, 20);
  REQUIRE(workcell.fault());
  workcell.advance_to(workcell.now() + 500ms);
  CHECK((workcell.tool().translation() - began).norm() < 0.5e-3);

  workcell.reset_fault();
  workcell.move({0, 0, -1, 0, 0, 0}, CorrectionFrame::tool, workcell.now());
  workcell.advance_to(workcell.now() + 200ms);
  CHECK_FALSE(workcell.fault());
  CHECK((workcell.tool().translation() - began).z() > 0.5e-3);
}

TEST_CASE("faults: a finger that comes down on a part names it, and lets it be") {
  // The part stands aside, under one finger.
  const SceneText text("tool gripper\nstart 460 -200 -120\npart at 460 -160\n");
  Workcell workcell(text.scene());
  move_until_refused(workcell, {0, 0, 2, 0, 0, 0}, CorrectionFrame::tool, 120);
  REQUIRE(workcell.fault());
  CAPTURE(workcell.fault()->text);
  CHECK(workcell.fault()->kind == ArmFault::Kind::following_error);
  // The name comes first, for reasons are cut; what a finger meets from above is no grip.
  CHECK(workcell.fault()->text.find(" finger presses on the part; the tool is 5.") != std::string::npos);
  REQUIRE(workcell.fault()->place);
  CHECK(workcell.fault()->place->y() < -0.1);
  CHECK(workcell.log().back().contact_force > 20);
  CHECK(workcell.log().back().grip_force == 0);
  CAPTURE(workcell.log().back().contact_force);
  workcell.advance_to(workcell.now() + 500ms);
  CHECK(workcell.log().back().contact_force == 0);
}

TEST_CASE("faults: a destroyed listener is not called") {
  Workcell workcell(scene("bar-under-forearm"));
  int called = 0;
  workcell.on_fault([&](const ArmFault&) { ++called; }).reset();
  move_until_refused(workcell, {0, 0, 0.56, 0, 0, 0}, CorrectionFrame::tool, 200);
  CHECK(workcell.fault());
  CHECK(called == 0);
}

TEST_CASE("faults: the side of a tool is not its tip") {
  const SceneText text("tool pad\nstart 460 -200 -120\nmachine exact\nblock at 580 -200 size 40 100 200\n");
  Workcell workcell(text.scene());
  move_until_refused(workcell, {1, 0, 0, 0, 0, 0}, CorrectionFrame::world, 60);
  REQUIRE(workcell.fault());
  CHECK(workcell.fault()->text == "the force-torque sensor hit the block");
}

TEST_CASE("faults: pressed flat, the pad's holder hits what the pad was pressed on, and is relieved") {
  Workcell workcell(scene("touch"));
  move_until_refused(workcell, {0, 0, 1, 0, 0, 0}, CorrectionFrame::tool, 120);
  REQUIRE(workcell.fault());
  CHECK(workcell.fault()->text == "the tool hit the plate");
  const double met = workcell.log().back().contact_force;
  CHECK(met > 150);
  workcell.advance_to(workcell.now() + 500ms);
  CHECK(workcell.log().back().contact_force < 0.6 * met);
}

TEST_CASE("faults: a following error of more than 5 mm") {
  // Steel fingers on a steel plate: the drives give all they have, and the arm stands.
  const SceneText hand("tool gripper\nstart 480 -200 -140\nplate at 480 -200\n");
  Workcell workcell(hand.scene());
  move_until_refused(workcell, {0, 0, 1, 0, 0, 0}, CorrectionFrame::tool, 120);
  REQUIRE(workcell.fault());
  CAPTURE(workcell.fault()->text);
  CHECK(workcell.fault()->kind == ArmFault::Kind::following_error);
  const std::string& said = workcell.fault()->text;
  CHECK(said.starts_with("the gripper's "));
  CHECK(said.find(" finger presses on the plate; the tool is 5.") != std::string::npos);
  CHECK(said.ends_with(" from where it was told to be"));
}

TEST_CASE("faults: the range finder may touch nothing, the gripper's fingers may") {
  const SceneText finder("tool range-finder\nstart 480 -200 -60\nplate at 480 -200\n");
  Workcell workcell(finder.scene());
  move_until_refused(workcell, {0, 0, 2, 0, 0, 0}, CorrectionFrame::tool, 120);
  REQUIRE(workcell.fault());
  CHECK(workcell.fault()->text == "the range finder hit the plate");

  const SceneText hand("tool gripper\nstart 480 -200 -140\nplate at 480 -200\n");
  Workcell gripper(hand.scene());
  move_until_refused(gripper, {0, 0, 0.5, 0, 0, 0}, CorrectionFrame::tool, 34);
  CHECK_FALSE(gripper.fault());
  CHECK(gripper.log().back().contact_force > 1);
}

TEST_CASE("faults: the arm meets itself") {
  // The arm folds until what it carries comes to the upper arm.
  const SceneText text("no table\ntool range-finder\nstart 250 0 100\nconfiguration lefty above noflip\n");
  Workcell workcell(text.scene());
  const std::string refused = move_until_refused(workcell, {-2, 0, 0, 0, 0, 0}, CorrectionFrame::world, 400);
  CAPTURE(refused);
  REQUIRE(workcell.fault());
  CHECK(workcell.fault()->kind == ArmFault::Kind::self_collision);
  CHECK(workcell.fault()->text == "the range finder hit the upper arm");
}

TEST_CASE("faults: a start at which any part of the arm touches something is refused") {
  const auto refused = [](const std::string& things) {
    const SceneText text("start 560 -200 -100\n" + things);
    try {
      Workcell workcell(text.scene());
    } catch (const SceneError& error) {
      return error.cause();
    }
    return std::string("loaded");
  };
  CHECK(refused("plate at 560 -200\n") == "loaded");
  CHECK(refused("bar at 440 -200 85 length 300 turn 90\n") ==
        "at its start the forearm touches the bar of line 2");
  CHECK(refused("block at 560 -200 size 60 60 100\n") ==
        "at its start the tool's tip touches the block of line 2");
}

TEST_CASE("faults: a scene whose contacts do not fit is refused") {
  // A pile of boxes wants more contacts than there is room for.
  std::string heap = R"(<mujoco><include file="puma560.xml"/><size nconmax="8"/><custom>)"
                     R"(<numeric name="start" data="0.46 -0.2 0.1 0"/></custom><worldbody>)";
  for (int i = 0; i < 6; ++i)
    heap += "<body pos=\"0.8 0.4 " + std::to_string(0.1 + 0.0999 * i) +
            "\"><freejoint/><geom class=\"cell\" type=\"box\" size=\".05 .05 .05\" mass=\"1\"/></body>";
  const SceneText text(heap + "</worldbody></mujoco>", ".xml");
  try {
    Workcell workcell(text.scene());
    FAIL("loaded");
  } catch (const SceneError& error) {
    CHECK(error.place() == text.file());
    CHECK(error.cause() == "there are more contacts than the scene has room for, and some were left out");
  }
}

TEST_CASE("faults: a run in which contacts no longer fit ends with an error") {
  // The heap falls on the floor after the start.
  std::string heap = R"(<mujoco><include file="puma560.xml"/><size nconmax="8"/><custom>)"
                     R"(<numeric name="start" data="0.46 -0.2 0.1 0"/></custom><worldbody>)";
  for (int i = 0; i < 6; ++i)
    heap += "<body pos=\"0.8 " + std::to_string(0.2 * i) +
            " 0.8\"><freejoint/><geom class=\"cell\" type=\"box\" size=\".05 .05 .05\" mass=\"1\"/></body>";
  const SceneText text(heap + "</worldbody></mujoco>", ".xml");
  Workcell workcell(text.scene(), {.settle = 20ms});
  CHECK_THROWS_WITH(workcell.advance_to(2s),
                    "there are more contacts than the scene has room for, and some were left out");
}
