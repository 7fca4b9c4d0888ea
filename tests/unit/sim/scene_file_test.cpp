// The .scene format: what it says, what it refuses, and that every scene of the project loads.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sim/model/scene_description.hpp"
#include "sim/random.hpp"
#include "tests/unit/sim/scene_text.hpp"
#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;

namespace {

SceneError refused(const std::string& text) {
  try {
    parse_description(text, "my.scene");
  } catch (const SceneError& error) {
    return error;
  }
  FAIL("accepted: " << text);
  return {"", "", ""};
}

// Place and cause of a scene whose second line is wrong.
std::string second_line(const std::string& line) {
  const SceneError error = refused("start 1 2 3\n" + line + "\n");
  CHECK_FALSE(error.hint().empty());
  return error.place() + ": " + error.cause();
}

}  // namespace

TEST_CASE("scene files: what they say") {
  const SceneDescription scene = parse_description(
      "about  two posts, \"near\"  # not a remark, but a part of the text\n"
      "\n"
      "# a remark\n"
      "tool gripper\r\n"
      "start 460 -200.5 +60 90   # and another\n"
      "configuration noflip lefty below\n"
      "machine seed 7\n"
      "no table\n"
      "location PART_2 460 105 -156.8 90\n"
      "sensor part-height at 460 -200 118.5\n"
      "post at 1 2\n"
      "post at 3 4 5 diameter 12\n"
      "part \"blue one\" at 0 0 mass 150 turn 45\n",
      "my.scene");
  CHECK(scene.about == "two posts, \"near\"  # not a remark, but a part of the text");
  CHECK(scene.tool == ToolKind::gripper);
  CHECK(*scene.start == std::array<double, 4>{460, -200.5, 60, 90});
  CHECK(scene.configuration == Configuration{.righty = false, .above = false, .flip = false});
  CHECK(scene.machine.seed == 7);
  CHECK(scene.machine.encoders);
  CHECK(scene.machine.noise);
  CHECK_FALSE(scene.table);
  REQUIRE(scene.locations.size() == 1);
  CHECK(scene.locations[0].name == "PART_2");
  CHECK(scene.locations[0].tip == std::array<double, 4>{460, 105, -156.8, 90});
  REQUIRE(scene.sensors.size() == 1);
  CHECK(scene.sensors[0].name == "part-height");
  CHECK(scene.sensors[0].at == std::array<double, 3>{460, -200, 118.5});
  REQUIRE(scene.things.size() == 3);
  CHECK(scene.things[0].name == "post 1");
  CHECK(scene.things[0].all("at") == std::vector<double>{1, 2, table_top});  // it stands on the table
  CHECK(scene.things[1].name == "post 2");
  CHECK(scene.things[1].all("at") == std::vector<double>{3, 4, 5});
  CHECK(scene.things[1].one("diameter") == 12);
  CHECK(scene.things[1].one("height") == 300);
  CHECK(scene.things[2].name == "blue one");
  CHECK(scene.things[2].line == 13);
}

TEST_CASE("scene files: an error has its line, its cause and a hint") {
  const SceneError unknown = refused("start 1 2 3\nplait at 1 2\n");
  CHECK(unknown.place() == "my.scene:2");
  CHECK(unknown.cause() == "'plait' is not something that a scene has");
  CHECK(unknown.hint().find("a line begins with about, tool, start") == 0);
  CHECK(unknown.hint().find("plate, sponge") != std::string::npos);

  CHECK(second_line("plate at 1") == "my.scene:2: 'at' has 1 figures instead of 2");
  CHECK(second_line("plate at one two") == "my.scene:2: 'one' is not a number");
  CHECK(second_line("plate size 1 2 3") == "my.scene:2: this plate does not say 'at'");
  CHECK(second_line("plate at 1 2 colour 3") == "my.scene:2: a plate has no 'colour'");
  CHECK(second_line("plate at 1 2 3 4") == "my.scene:2: a plate has no '4'");
  CHECK(second_line("plate at 1 2 at 3 4") == "my.scene:2: 'at' is said twice");
  CHECK(second_line("plate at 1 2 stiffness -1") ==
        "my.scene:2: 'stiffness' is -1, which is out of its range");
  CHECK(second_line("plate at 1 2 tilt 80 0") == "my.scene:2: 'tilt' is 80, which is out of its range");
  CHECK(second_line("plate at nan 2") == "my.scene:2: 'nan' is not a number");
  CHECK(second_line("plate \"left at 1 2") == "my.scene:2: a quotation mark is not closed");
  CHECK(second_line("plate \"a<b\" at 1 2") ==
        "my.scene:2: the name 'a<b' has a character that names cannot have");
  CHECK(second_line("tool hammer") == "my.scene:2: 'hammer' is not a tool");
  CHECK(second_line("tool pad pad") == "my.scene:2: 'pad' is one word too many");
  CHECK(second_line("start 4 5 6") == "my.scene:2: 'start' is said twice");
  CHECK(second_line("configuration sideways") == "my.scene:2: 'sideways' is not a configuration of the arm");
  CHECK(second_line("machine seed -1") ==
        "my.scene:2: '-1' is not a seed, which is a whole number from 0 on");
  CHECK(second_line("machine without motors") ==
        "my.scene:2: 'motors' is not something that a machine can be without");
  CHECK(second_line("sensors blind") == "my.scene:2: the sensors can only be exact");
  CHECK(second_line("no chairs") == "my.scene:2: only the table can be left out");
  CHECK(second_line("location part 1 2 3") == "my.scene:2: 'part' is not a name of VAL");
  CHECK(second_line("location PART 1 2") == "my.scene:2: the location has too few figures");
  CHECK(refused("start 1 2 3\nlocation P 1 2 3\nlocation P 1 2 3\n").cause() == "location P is said twice");
  CHECK(second_line("sensor Eye at 1 2 3") == "my.scene:2: 'Eye' is not a name of a sensor");
  CHECK(second_line("sensor eye 1 2 3") == "my.scene:2: the sensor does not say where it stands");
  CHECK(second_line("sensor eye at 1 2") == "my.scene:2: the sensor has too few figures");
  CHECK(second_line("sensor eye at 1 2 x") == "my.scene:2: 'x' is not a number");
  CHECK(second_line("sensor force-z at 1 2 3") ==
        "my.scene:2: sensor 'force-z' begins as those of the arm do");
  CHECK(refused("start 1 2 3\nsensor s at 1 2 3\nsensor s at 1 2 3\n").cause() == "sensor s is said twice");
  CHECK(second_line("about") == "my.scene:2: 'about' needs a text");
  CHECK(second_line("post \"tool\" at 1 2") == "my.scene:2: there is more than one thing named 'tool'");

  CHECK(refused("start 1 2\n").cause() == "the start has too few figures");
  CHECK(refused("plate at 1 2\n").cause() == "the scene does not say where the tool starts");
  CHECK(refused("").place() == "my.scene:1");

  const SceneText deep("start 480 -200 100\ntool range-finder\nsurface at 480 -200 size 200 200 20\n");
  try {
    Workcell workcell(deep.scene());
    FAIL("loaded");
  } catch (const SceneError& error) {
    CHECK(error.place() == deep.file() + ":3");
    CHECK(error.cause().find("the surface is ") == 0);
  }
}

TEST_CASE("scene files: an impossible start names its line and the line of the obstacle") {
  const auto error = [](const std::string& text) {
    const SceneText scene(text);
    try {
      Workcell workcell(scene.scene());
    } catch (const SceneError& refused) {
      return refused.place().substr(scene.file().size()) + ": " + refused.cause();
    }
    return std::string("loaded");
  };
  CHECK(error("\nstart 1200 0 0\n") == ":2: the arm cannot bring the tool to its start as righty above flip");
  CHECK(error("plate at 460 -200\npost at 460 -200 height 60\nstart 460 -200 -150\n") ==
        ":3: at its start the tool touches the post of line 2");
  CHECK(error("start 460 -200 -190\n") == ":1: at its start the tool's tip touches the table");
}

TEST_CASE("scene files: nothing is sunk into the floor or into the table") {
  CHECK(second_line("plate at 460 -200 -700") ==
        "my.scene:2: the underside of the plate is at z = -700, below the floor");
  CHECK(second_line("bar at -900 0 -671.9") ==
        "my.scene:2: the underside of the bar is at z = -671.9, below the floor");
  CHECK(second_line("block at 460 -200 -200") ==
        "my.scene:2: the underside of the block is at z = -200, inside the table");
  CHECK_NOTHROW(
      parse_description("start 1 2 3\nblock at 460 -200 -671.8\nblock at 0 -200 -200\n", "my.scene"));
  CHECK_NOTHROW(parse_description("start 1 2 3\nno table\nblock at 460 -200 -200\n", "my.scene"));
}

TEST_CASE("scene files: a part in the place of something else is refused with both lines") {
  const auto cause = [](const std::string& text) {
    const SceneText file("start 460 -200 0\n" + text);
    try {
      Workcell workcell(file.scene());
    } catch (const SceneError& error) {
      return error.place().substr(file.file().size()) + ": " + error.cause();
    }
    return std::string("accepted");
  };
  CHECK(cause("part at 400 -320\npart at 430 -300\n") == ":3: part 2 overlaps part 1 of line 2");
  CHECK(cause("plate at 460 -200\npart at 460 -200\n") == ":3: the part overlaps the plate of line 2");
  CHECK(cause("no table\npart at 460 -200 -671.8\npost at 460 -200 -671.8\n") ==
        ":3: the part overlaps the post of line 4");
  // One upon the other, and side by side.
  CHECK(cause("plate at 460 -200\npart at 460 -200 -166.8\npart at 460 -200 -116.8\n") == "accepted");
  CHECK(cause("part at 400 -320\npart at 450 -320\n") == "accepted");
}

TEST_CASE("scene files: a surface is felt where it is seen") {
  const SceneText text("tool pad\nstart 500 -200 -100\nsurface at 500 -200\n");
  Workcell workcell(text.scene());
  const auto seen = workcell.cast(workcell.tool().translation(), {0, 0, -1});
  REQUIRE(seen);
  const double start = workcell.tool().translation().z();
  while (workcell.log().empty() || workcell.log().back().contact_force < 1) {
    REQUIRE_FALSE(workcell.move({0, 0, 0.3, 0, 0, 0}, CorrectionFrame::tool, workcell.now()));
    workcell.advance_to(workcell.now() + alter_period);
    REQUIRE(start - workcell.tool().translation().z() < *seen + 0.01);
  }
  CHECK(start - workcell.tool().translation().z() == Approx(*seen).margin(1.5e-3));
}

TEST_CASE("scene files: a loose body of a scene in MJCF lies on its table") {
  const SceneText text(
      R"(<mujoco><include file="puma560.xml"/><include file="cell.xml"/><custom><numeric name="start" )"
      R"(data="0.46 -0.2 0 0"/></custom><worldbody><body name="box" pos="0.5 -0.2 0.53"><freejoint/>)"
      R"(<geom class="cell" type="box" size=".02 .02 .02" mass=".1"/></body></worldbody></mujoco>)",
      ".xml");
  Workcell workcell(text.scene());
  workcell.advance_to(1s);
  // 490 mm above the floor, 181.8 mm below the shoulder; the box is 40 mm high.
  const auto below = workcell.cast({0.5, -0.2, -0.05}, {0, 0, -1});
  REQUIRE(below);
  CHECK(*below == Approx(0.0918).margin(1e-3));
}

TEST_CASE("scene files: every scene of the project loads, and says what it is") {
  for (const Scene& each : list_scenes({PAL_SCENE_DIR})) {
    CAPTURE(each.name);
    CHECK_FALSE(describe_scene(each).empty());
    Workcell workcell(each, {.settle = 20ms});
    workcell.advance_to(20ms);
    CHECK_FALSE(workcell.fault());
    const auto below = workcell.cast(workcell.tool().translation(), workcell.tool().linear().col(2));
    REQUIRE(below);  // the table, at least
    CHECK(*below < 0.4);
  }
}

TEST_CASE("scene files: values within the ranges load, or are refused in our words") {
  const std::uint64_t seed = 11;
  CAPTURE(seed);
  Random random(seed, 0);
  const auto draw = [&](double low, double high) {
    // The ends of a range, small figures and any figure.
    const double choice = random.unit();
    if (choice < 0.2) return low;
    if (choice < 0.4) return high;
    if (choice < 0.7) return std::clamp(low + 100 * random.unit(), low, high);
    return low + (high - low) * random.unit();
  };
  for (const ThingKind& kind : thing_kinds()) {
    for (int i = 0; i < 8; ++i) {
      std::ostringstream text;
      text << "start 460 -200 0\n" << kind.name;
      for (const Setting& setting : kind.settings) {
        if (!setting.needed && random.unit() < 0.4) continue;
        text << ' ' << setting.name;
        // A sheet of 2 m by 2 m at 0.5 mm would be slow to make, not wrong.
        const double high = setting.name == "size" ? 300 : setting.high;
        for (std::size_t k = 0; k < setting.most; ++k)
          text << ' '
               << (setting.unit == "pieces" ? std::floor(draw(setting.low, high)) : draw(setting.low, high));
      }
      const SceneText scene(text.str() + "\n");
      CAPTURE(text.str());
      try {
        Workcell workcell(scene.scene(), {.settle = 5ms});
      } catch (const SceneError& error) {
        CHECK(error.place().find(scene.file()) == 0);
        CHECK_FALSE(error.hint().empty());
      }
    }
  }
}

TEST_CASE("scene files: random text is read or refused with its line") {
  const std::uint64_t seed = 5;
  CAPTURE(seed);
  Random random(seed, 0);
  const std::string text =
      "about a\ntool gripper\nstart 460 -200 -60 0\nmachine seed 3\nplate \"a b\" at 1 2 3 size 1 2 3 tilt 4 "
      "5\nno "
      "table\n";
  for (int i = 0; i < 3000; ++i) {
    std::string changed = text;
    for (int k = 0; k < 1 + i % 4; ++k) {
      const auto at = static_cast<std::size_t>(random.unit() * static_cast<double>(changed.size()));
      if (random.unit() < 0.5) {
        changed.erase(at, 1 + static_cast<std::size_t>(random.unit() * 6));
      } else {
        changed.insert(at, 1, static_cast<char>(random.unit() * 256));
      }
    }
    try {
      parse_description(changed, "my.scene");
    } catch (const SceneError& error) {
      CHECK(error.place().find("my.scene:") == 0);
    }
  }
}

TEST_CASE("scene files: plates give way as they say, in series with the pad") {
  for (const auto& [name, stiffness] : std::vector<std::pair<std::string, double>>{
           {"plate-1", 1}, {"plate-5", 5}, {"plate-20", 20}, {"sponge", 1}}) {
    Workcell workcell(scene(name));
    const auto press = [&](double distance) {
      for (int i = 0; i < 10; ++i) {
        REQUIRE_FALSE(workcell.move({0, 0, distance / 10, 0, 0, 0}, CorrectionFrame::tool, workcell.now()));
        workcell.advance_to(workcell.now() + alter_period);
      }
      workcell.advance_to(workcell.now() + 600ms);
      return workcell.log().back().contact_force;
    };
    press(14);
    const double first = press(4), second = press(2);
    // The pad, 20 N/mm, and the contact, whose softness is as great, stand in series with the plate.
    const double series = 1 / (1 / stiffness + 1 / 10.0);
    CAPTURE(name, first, second);
    CHECK(first > 0);
    CHECK((second - first) / 2 == Approx(series).epsilon(0.2));
  }
}

TEST_CASE("rays see the scene and not the arm") {
  const SceneText text(
      "tool range-finder\nstart 480 -200 100\npyramid at 480 -200 size 120 120 60 steps 4\n");
  Workcell workcell(text.scene());
  const Pose tip = workcell.tool();
  const Eigen::Vector3d down = tip.linear().col(2);
  const auto height_at = [&](double x, double y) {
    const auto distance = workcell.cast({x * 1e-3, y * 1e-3, 0.1}, {0, 0, -2});
    REQUIRE(distance);
    return 100 - *distance * 1e3 - table_top;
  };
  CHECK(*workcell.cast(tip.translation(), down) * 1e3 == Approx(100 - (table_top + 60)).margin(0.2));
  CHECK(height_at(480, -200) == Approx(60).margin(1e-9));
  CHECK(height_at(480, -200 + 20) == Approx(45).margin(1e-9));
  CHECK(height_at(480 + 40, -200) == Approx(30).margin(1e-9));
  CHECK(height_at(480 + 55, -200 + 55) == Approx(15).margin(1e-9));
  CHECK(height_at(480 + 70, -200) == Approx(0).margin(1e-9));
  // From behind the flange the arm stands in the way, and is looked through.
  CHECK(*workcell.cast(tip * Eigen::Vector3d(0, 0, -0.15), down) * 1e3 ==
        Approx(250 - (table_top + 60)).margin(0.2));
  CHECK_FALSE(workcell.cast(tip.translation(), {0, 0, 1}));
}
